#pragma once
#include "model/pipeline/evaluator.h"
#include "model/pipeline/unit/combine.h"

namespace ptm::pipeline {

/// The evaluator's time inside the unit; its values are the reference's.
class UnitEvaluator final : public sc_core::sc_module {
 public:
  UnitEvaluator(const sc_core::sc_module_name& name, Combine& out) : sc_module(name), out_(out) {}

  Cycle accept(bool completes, Cycle offered) {
    return time_.accept(completes, offered,
                        [&](Cycle at_output) { return out_.accept(at_output); });
  }
  void reset() { time_ = {}; }

 private:
  Combine& out_;
  EvaluatorTime time_;
};

}  // namespace ptm::pipeline
