#pragma once
#include "model/pipeline/unit/effect_chain.h"

namespace ptm::pipeline {

/// C1 (products of U11) and C2 (result); behind them the effect chain, if there is one.
class Combine final : public sc_core::sc_module {
 public:
  Combine(const sc_core::sc_module_name& name, UnitSink& out, EffectChain& chain)
      : sc_module(name), out_(out), chain_(chain) {}

  template <bool kEffects>
  Cycle accept(Cycle offered) {
    return registers_.accept(offered, [&](Cycle at_output) {
      if constexpr (kEffects) {
        if (!chain_.empty()) return chain_.accept(at_output);
      }
      return out_.accept(at_output);
    });
  }
  void reset() { registers_ = {}; }

 private:
  UnitSink& out_;
  EffectChain& chain_;
  RegisterChain<2> registers_;
};

}  // namespace ptm::pipeline
