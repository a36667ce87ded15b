#pragma once
#include "model/pipeline/evaluator.h"
#include "model/pipeline/unit/combine.h"

namespace ptm::pipeline {

/// The evaluator's time inside the unit; its values are the reference's.
class UnitEvaluator final : public sc_core::sc_module {
 public:
  UnitEvaluator(const sc_core::sc_module_name& name, Combine& out) : sc_module(name), out_(out) {}

  template <bool kEffects>
  Cycle accept(bool completes, Cycle offered) {
    return time_.accept(completes, offered,
                        [&](Cycle at_output) { return out_.accept<kEffects>(at_output); });
  }
  /// A pass beyond the map's own: its luminance is taken behind the FIFO as soon as it is offered.
  Cycle accept_extra(Cycle offered) {
    return time_.accept(true, offered, [](Cycle at_output) { return at_output; });
  }
  void reset() { time_ = {}; }

 private:
  Combine& out_;
  EvaluatorTime time_;
};

}  // namespace ptm::pipeline
