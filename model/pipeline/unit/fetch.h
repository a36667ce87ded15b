#pragma once
#include "model/pipeline/unit/palette.h"

namespace ptm::pipeline {

/// F: reads the data banks of each TMU as the beat leaves for D.
class Fetch final : public sc_core::sc_module {
 public:
  Fetch(const sc_core::sc_module_name& name, Palette& out) : sc_module(name), out_(out) {}

  /// F accepts from this cycle on.
  [[nodiscard]] Cycle free() const { return free_; }
  /// The beat's transfer into F, not before free().
  void accept(const UnitBeat& beat, Cycle enter) { free_ = out_.accept(beat, enter + 1); }
  void reset() { free_ = 0; }

 private:
  Palette& out_;
  Cycle free_ = 0;
};

}  // namespace ptm::pipeline
