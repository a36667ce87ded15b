#pragma once
#include "model/reference/rounding.h"

namespace ptm::reference {

inline constexpr int kLerpFrac = 8;  ///< filter weights are Q0.8

/// Linear interpolation of stored, unsigned values before D1.
///
///     lerp(a, b, f) = a + narrow((b - a) * f, 8)        Eq. 14 of Polynomial Texture Maps
///
/// Format    a, b unsigned, texels entering as x << filter_frac; f in 0..255, 2^-8 units.
///           The result lies between a and b, so it needs no more bits than they have.
/// Error     half a unit (nearest), one (truncate)
/// Twin      rtl/arith/ptm_arith_lerp.sv
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Int lerp(Rounding rounding, Int a, Int b, Int f) {
  const StepScope<Int> scope(Step::lerp);
  return a + narrow(rounding, (b - a) * f, Value{kLerpFrac});
}

}  // namespace ptm::reference
