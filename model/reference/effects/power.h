#pragma once
#include "model/reference/effects/stage.h"
#include "model/reference/rounding.h"

namespace ptm::reference::effects {

/// X2 of docs/spec/effects.md: the specular term, a power by table, the same for every channel.
///
///     x = min(value[0], 255 << lum_frac), i = x >> lum_frac, f = x - (i << lum_frac)
///     e = table[i] + narrow((table[min(i + 1, 255)] - table[i]) * f, lum_frac)
///     addend[c] = narrow(ks * e, 8)
///
/// Source    (N.H)^n of Eq. 8 and 15 of Polynomial Texture Maps
/// Format    e Q8.4 levels, 12 bits unsigned (it lies between two entries); addend Q9.4, 13 bits:
///           (511 * 4095 + 128) >> 8 = 8174
/// Error     of the page, "Error of the power table", from value[0] to e; 1/32 level of addend for
///           the last narrow (nearest), 1/16 (truncate)
/// Multiplies  ks * e, and the lerp's if there are fraction bits to lerp by
/// Twins     rtl/effects/ptm_effect_power.sv; model/pipeline/effects/power.h (time)
struct power {
  static constexpr unsigned multiplies(const EvalConfig& config, const Draw&) {
    return config.lum_frac > 0 ? 2 : 1;
  }

  template <class Int>
  static constexpr void apply(const StageInput<Int>& in, StagePixel<Int>& pixel) {
    const StepScope<Int> scope(Step::power);
    const EvalConfig& config = in.config;
    const Int x = smaller(in.value[0], Int{Value{255} << config.lum_frac});
    const Int i = shift_right(x, Value{config.lum_frac});
    Int e = look_up(in.table, i);
    if (config.lum_frac > 0) {
      const Int f = x - shift_left(i, config.lum_frac);
      const Int next = look_up(in.table, smaller(i + Int{Value{1}}, Int{Value{255}}));
      e = e + narrow(config.rounding, (next - e) * f, Value{config.lum_frac});
    }
    const Int specular = narrow(config.rounding, Int{in.draw.ks} * e, Value{8});
    pixel.addend.fill(specular);
  }
};

}  // namespace ptm::reference::effects
