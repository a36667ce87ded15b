#pragma once
#include "model/reference/effects/stage.h"
#include "model/reference/rounding.h"

namespace ptm::reference::effects {

/// X4 of docs/spec/effects.md: the addend onto the pixel's colour. Alpha and flags stay.
///
///     rgb[c] = min(255, rgb[c] + narrow(addend[c], 4))
///
/// Source    Eq. 8 of Polynomial Texture Maps: diffuse plus specular
/// Error     half a level (nearest), one (truncate), before the limit
/// Multiplies  none
/// Twins     rtl/effects/ptm_effect_add.sv; model/pipeline/effects/add.h (time)
struct add {
  static constexpr unsigned multiplies(const EvalConfig&, const Draw&) { return 0; }

  template <class Int>
  static constexpr void apply(const StageInput<Int>& in, StagePixel<Int>& pixel) {
    const StepScope<Int> scope(Step::add);
    for (std::size_t c = 0; c < pixel.rgb.size(); ++c) {
      const Int levels = narrow(in.config.rounding, pixel.addend[c], Value{4});
      pixel.rgb[c] = smaller(pixel.rgb[c] + levels, Int{Value{255}});
    }
  }
};

}  // namespace ptm::reference::effects
