#pragma once
#include <systemc>
#include <vector>

#include "model/pipeline/evaluator.h"

namespace ptm::pipeline {

/// Takes pixels in order and notes the cycle of each; refuses in the cycles that `timing` says.
class PixelSink final : public sc_core::sc_module, public StreamTarget<PixelBeat> {
 public:
  sc_core::sc_export<StreamTarget<PixelBeat>> in{"in"};

  PixelSink(const sc_core::sc_module_name& name, const StreamTiming& timing)
      : sc_module(name), timing_(timing) {
    in.bind(*this);
  }

  Cycle accept(const PixelBeat& beat, Cycle offered) override {
    Cycle taken = offered;
    while (stalled(timing_, taken)) ++taken;
    output_blocked_ += taken - offered;
    pixels_.push_back(beat.pixel);
    cycles_.push_back(taken);
    return taken;
  }

  void reset(std::size_t expected) {
    pixels_.clear();
    cycles_.clear();
    pixels_.reserve(expected);
    cycles_.reserve(expected);
    output_blocked_ = 0;
  }

  [[nodiscard]] std::vector<Pixel>& pixels() { return pixels_; }
  [[nodiscard]] std::vector<Cycle>& cycles() { return cycles_; }
  /// Cycles in which a pixel stood at the output and was not taken.
  [[nodiscard]] std::uint64_t output_blocked() const { return output_blocked_; }

 private:
  StreamTiming timing_;
  std::vector<Pixel> pixels_;
  std::vector<Cycle> cycles_;
  std::uint64_t output_blocked_ = 0;
};

}  // namespace ptm::pipeline
