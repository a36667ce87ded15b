#pragma once
#include <memory>

#include "model/pipeline/registers.h"
#include "model/pipeline/unit/unit_sink.h"

namespace ptm::pipeline {

/// A stage behind the combine stage: plain registers, whatever it computes.
class EffectStage : public sc_core::sc_module {
 public:
  using sc_module::sc_module;
  ~EffectStage() override;
  /// Returns the cycle in which the stage takes the pixel.
  virtual Cycle accept(Cycle offered) = 0;
  virtual void reset() = 0;
};

/// The stages that the unit is built with, a module each (`power_stage`, ...), in the order of
/// their numbers; none of the others. Every pixel of every draw goes through all of them.
class EffectChain {
 public:
  /// Within the constructor of the module that they belong to.
  EffectChain(unsigned stages, UnitSink& sink);
  [[nodiscard]] bool empty() const { return stages_.empty(); }
  /// Requires a stage.
  Cycle accept(Cycle offered) { return stages_.back()->accept(offered); }
  void reset() {
    for (const auto& stage : stages_) stage->reset();
  }

 private:
  std::vector<std::unique_ptr<EffectStage>> stages_;  ///< the last one first
};

}  // namespace ptm::pipeline
