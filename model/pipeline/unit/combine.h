#pragma once
#include "model/pipeline/registers.h"
#include "model/pipeline/unit/unit_sink.h"

namespace ptm::pipeline {

/// C1 (products of U11) and C2 (result).
class Combine final : public sc_core::sc_module {
 public:
  Combine(const sc_core::sc_module_name& name, UnitSink& out) : sc_module(name), out_(out) {}

  Cycle accept(Cycle offered) {
    return registers_.accept(offered, [&](Cycle at_output) { return out_.accept(at_output); });
  }
  void reset() { registers_ = {}; }

 private:
  UnitSink& out_;
  RegisterChain<2> registers_;
};

}  // namespace ptm::pipeline
