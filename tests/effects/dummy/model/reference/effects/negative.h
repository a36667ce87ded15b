#pragma once
#include "model/reference/effects/stage.h"

namespace ptm::reference::effects {

/// rgb[c] = 255 - rgb[c]
struct negative {
  static constexpr unsigned multiplies(const EvalConfig&, const Draw&) { return 0; }

  template <class Int>
  static constexpr void apply(const StageInput<Int>&, StagePixel<Int>& pixel) {
    for (Int& level : pixel.rgb) level = Int{Value{255}} - level;
  }
};

}  // namespace ptm::reference::effects
