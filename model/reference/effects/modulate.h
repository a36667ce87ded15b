#pragma once
#include "model/reference/effects/stage.h"
#include "model/reference/rounding.h"

namespace ptm::reference::effects {

/// X3 of docs/spec/effects.md: the addend by one polynomial of the light, or one a channel.
///
///     m[c] = min(255, narrow(value[1 + c], lum_frac)) with argument bit 0, else value[1]'s for all
///     addend[c] = narrow(addend[c] * (m[c] + (m[c] >> 7)), 8)
///
/// Source    modulated specular, Eq. 15 of Polynomial Texture Maps; section 3.7
/// Format    m + (m >> 7) is 0..256, so the addend keeps its 13 bits; 255 leaves it as it is
/// Error     (m + (m >> 7)) / 256 is within 127 / 65,280 < 1/512 of m / 255, worst at m = 127 and
///           128; m within half a level of the value (nearest), one (truncate), if that is below
///           255; half of 1/16 level for the last narrow (nearest), 1/16 (truncate)
/// Multiplies  one a channel that differs
/// Twins     rtl/effects/ptm_effect_modulate.sv; model/pipeline/effects/modulate.h (time)
struct modulate {
  static constexpr std::uint32_t kThreeChannels = 1;  ///< of a draw's argument

  static constexpr unsigned multiplies(const EvalConfig&, const Draw& draw) {
    return three(draw) ? 3 : 1;
  }

  template <class Int>
  static constexpr void apply(const StageInput<Int>& in, StagePixel<Int>& pixel) {
    const StepScope<Int> scope(Step::modulate);
    const auto scaled = [&](unsigned c) -> Int {
      const Int level = narrow_constant(in.config.rounding, in.value[1 + c], in.config.lum_frac);
      const Int m = smaller(level, Int{Value{255}});
      return narrow(in.config.rounding, pixel.addend[c] * (m + shift_right(m, Value{7})), Value{8});
    };
    if (three(in.draw)) {
      pixel.addend = {scaled(0), scaled(1), scaled(2)};
    } else {
      pixel.addend.fill(scaled(0));  // all three are one: no stage before makes them differ
    }
  }

 private:
  static constexpr bool three(const Draw& draw) {
    return (draw.effects.argument & kThreeChannels) != 0;
  }
};

}  // namespace ptm::reference::effects
