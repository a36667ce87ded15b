#pragma once

namespace ptm::pipeline::effects {

/// X4's time: docs/spec/effects.md, "Time". Values are model/reference/effects/add.h's.
/// Twin      rtl/effects/ptm_effect_add.sv
struct add {
  static constexpr int registers = 1;  ///< the sum
};

}  // namespace ptm::pipeline::effects
