#pragma once
#include "model/pipeline/unit/unit_beat.h"
#include "model/pipeline/unit/unit_evaluator.h"

namespace ptm::pipeline {

/// Q, P, L1, L2, L3 and O: a beat's taps become a word, the beats of a fragment its operands, and
/// those one pass or three, behind those that effects add.
class Filter final : public sc_core::sc_module {
 public:
  Filter(const sc_core::sc_module_name& name, UnitEvaluator& out) : sc_module(name), out_(out) {}

  /// kEffects, here and upstream: the unit has stages behind the combine stage, or draws with extra
  /// passes. A whole beat offered to Q; returns the cycle in which Q takes it.
  template <bool kEffects>
  Cycle accept(const UnitBeat& beat, Cycle offered) {
    return registers_.accept(offered, [&](Cycle in_l3) {
      // To the accumulators at once, or with them to O.
      return beat.last ? send_passes<kEffects>(*beat.draw, in_l3) : in_l3;
    });
  }
  /// From when on Q accepts.
  [[nodiscard]] Cycle free() const { return registers_.free(); }
  void reset() {
    registers_ = {};
    operands_free_ = 0;
  }

 private:
  template <bool kEffects>
  Cycle send_passes(const DrawPlan& draw, Cycle offered) {
    const Cycle enter = std::max(offered, operands_free_);
    const unsigned passes = draw.passes;
    Cycle sent = enter;
    if constexpr (kEffects) {
      for (unsigned pass = 0; pass < draw.extra_passes; ++pass) sent = out_.accept_extra(sent + 1);
    }
    for (unsigned pass = 1; pass <= passes; ++pass) {
      sent = out_.accept<kEffects>(pass == passes, sent + 1);
    }
    operands_free_ = sent;
    return enter;
  }

  UnitEvaluator& out_;
  RegisterChain<5> registers_;
  Cycle operands_free_ = 0;  ///< when O's last pass left
};

}  // namespace ptm::pipeline
