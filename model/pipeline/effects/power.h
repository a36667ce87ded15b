#pragma once

namespace ptm::pipeline::effects {

/// X2's time: docs/spec/effects.md, "Time". Values are model/reference/effects/power.h's.
/// Twin      rtl/effects/ptm_effect_power.sv
struct power {
  static constexpr int registers = 3;  ///< table | lerp | product
};

}  // namespace ptm::pipeline::effects
