#pragma once
#include <array>

#include "model/reference/eval_config.h"

/// How far one evaluation may lie from the real polynomial, from the bits alone.
namespace ptm::reference {

/// Bounds on |hardware - real|, each by what loses it, in levels.
struct ErrorBound {
  double light = 0;      ///< the light's codes
  double basis = 0;      ///< D2: bits of lu^2, lv^2, lu lv that are dropped
  double terms = 0;      ///< D4: bits below the guard bits
  double luminance = 0;  ///< D6: bits below lum_frac
  double color = 0;      ///< D7 of an LRGB pixel: to whole levels of a channel
  double direct = 0;     ///< of an RGB map's: lum_frac
  /// Of the luminance after D6, both sides clamped alike.
  [[nodiscard]] double of_luminance() const { return light + basis + terms + luminance; }
  /// Of a channel of colour 0..255, limited to 255 on both sides.
  [[nodiscard]] double of_lrgb_channel(double color_level) const {
    return color_level / 255 * of_luminance() + color;
  }
  [[nodiscard]] double of_rgb_channel() const { return of_luminance() + direct; }
};

/// For the polynomial of real coefficients a_i = (coef_i - bias_i) 2^-shift_i, of which D1 limits
/// none, under any light of the unit disc (or, with `reach` > 1, of a disc of that radius within
/// the light codes' range).
///
///     delta     = 2^-(light_frac + 1), the farthest that a code lies from its light; twice that
///                 where the disc reaches the last code
///     light     = delta (|(2 a0, a2)| reach + |a3| + |(a2, 2 a1)| reach + |a4|)
///                 + delta^2 (|a0| + |a1| + |a2|)
///     basis     = step 2^-basis_frac (|a0| + |a1| + |a2|), if bits are dropped; step is 1 where
///                 the last code's square rounds up to where D2 saturates
///     terms     = step 2^-guard for each coefficient that is not 0 and has bits to drop
///     luminance = step 2^-lum_frac, if bits are dropped
///     color     = step + step / 255, the latter if bits of the product are dropped
///     direct    = step, if bits are dropped
///     step      = 1/2 (nearest) or 1 (truncate)
///
/// Derivation in docs/verification/error-bound.md; `basis`, `terms` and `luminance` together are
/// proved by Gappa (tests/formal/error_bound_test.cpp).
[[nodiscard]] ErrorBound error_bound(const EvalConfig& config, const std::array<double, 6>& a,
                                     const std::array<int, 6>& shift, double reach = 1);

}  // namespace ptm::reference
