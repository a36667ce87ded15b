#pragma once
#include "model/pipeline/unit/unit_beat.h"
#include "model/pipeline/unit/unit_evaluator.h"

namespace ptm::pipeline {

/// P, L1, L2, L3 and O: a beat's taps become a word, the beats of a fragment its operands, and
/// those one pass or three.
class Filter final : public sc_core::sc_module {
 public:
  Filter(const sc_core::sc_module_name& name, UnitEvaluator& out) : sc_module(name), out_(out) {}

  /// A whole beat offered to P; returns the cycle in which P takes it.
  Cycle accept(const UnitBeat& beat, Cycle offered) {
    return registers_.accept(offered, [&](Cycle in_l3) {
      // To the accumulators at once, or with them to O.
      return beat.last ? send_passes(beat.draw->passes, in_l3) : in_l3;
    });
  }
  void reset() {
    registers_ = {};
    operands_free_ = 0;
  }

 private:
  Cycle send_passes(unsigned passes, Cycle offered) {
    const Cycle enter = std::max(offered, operands_free_);
    Cycle sent = enter;
    for (unsigned pass = 1; pass <= passes; ++pass) sent = out_.accept(pass == passes, sent + 1);
    operands_free_ = sent;
    return enter;
  }

  UnitEvaluator& out_;
  RegisterChain<4> registers_;
  Cycle operands_free_ = 0;  ///< when O's last pass left
};

}  // namespace ptm::pipeline
