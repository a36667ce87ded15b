#pragma once

namespace ptm::pipeline::effects {

/// X3's time: docs/spec/effects.md, "Time". Values are model/reference/effects/modulate.h's.
/// Twin      rtl/effects/ptm_effect_modulate.sv
struct modulate {
  static constexpr int registers = 1;  ///< the products
};

}  // namespace ptm::pipeline::effects
