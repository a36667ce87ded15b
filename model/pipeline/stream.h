#pragma once
#include <array>
#include <cstdint>
#include <systemc>

#include "model/pipeline/stream_timing.h"
#include "model/reference/evaluate.h"

namespace ptm::pipeline {

/// A block's input. The call advances the block, and all behind it, by one item.
template <class Item>
class StreamTarget : public virtual sc_core::sc_interface {
 public:
  /// `offered`: the cycle from which the item is valid and held. Returns the cycle in which it is
  /// taken. Items come in order, `offered` after the previous item's return value.
  virtual Cycle accept(const Item& item, Cycle offered) = 0;
};

struct PixelId {
  std::int32_t x = 0, y = 0;
};

/// One beat of the evaluator; twin of the input ports of rtl/evaluator/ptm_evaluator.sv. An LRGB
/// pixel is one beat, an RGB-map pixel three: channels 0, 1, 2.
struct EvaluatorBeat {
  reference::Six<reference::Value> coef{}, bias{}, shift{};
  reference::Three<reference::Value> rgb{};
  reference::Value lu = 0, lv = 0;
  bool rgb_map = false;
  unsigned channel = 0;
  PixelId id;
};

}  // namespace ptm::pipeline
