#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "golden/files/image.h"
#include "golden/files/ptm_map.h"

/// Lights a map in double precision, straight from the papers' equations. Compiled without fused
/// multiply-add, so that a product and a sum are rounded where they are written.
namespace ptm::golden {

using Coefficients = std::array<double, 6>;  ///< a0..a5 of Eq. 5, in 8-bit levels
using Rgb = std::array<double, 3>;

/// Eq. 7: a_k = (coef_k - bias_k) * scale_k, for one of a texel's polynomials.
[[nodiscard]] Coefficients real_coefficients(const PtmMap& map, std::size_t texel,
                                             std::size_t polynomial = 0);

/// Eq. 5: a0 u^2 + a1 v^2 + a2 uv + a3 u + a4 v + a5, terms added in that order.
/// Of finite numbers a finite one: where a square, a product or a sum is beyond the largest double,
/// the exact value's side of it decides, and the result is at most the largest double in size.
[[nodiscard]] double luminance(const Coefficients& a, double u, double v);

/// color * value / 255, the share of 255 that a colour leaves of a value; infinite only if that is.
[[nodiscard]] double colored(double color, double value);

/// The lit colour of one texel, each channel clamped to [0, 255] and not rounded.
///
///     lrgb   rgb[c] * L / 255           L is not clamped before the product
///     rgb    L of the channel's own polynomial
///     lum    matrix * (Cr, L, Cb, 1)    L is not clamped before the product
///
/// Error     a few units of 2^-53 relative to the largest term
/// Requires  finite u, v; outside the unit disc the polynomial extrapolates (section 4.1)
[[nodiscard]] Rgb light_texel(const PtmMap& map, std::size_t texel, double u, double v);

/// Every texel under one light: [height][width][3], row 0 the top.
[[nodiscard]] ImageReal light_map(const PtmMap& map, double u, double v);

enum class Rounding8 : std::uint8_t {
  nearest,  ///< floor(x + 1/2)
  truncate  ///< floor(x), as RTIViewer does
};

/// 8-bit samples of a real-valued picture, limited to [0, 255]. std::invalid_argument for NaN.
[[nodiscard]] Image8 to_8_bit(const ImageReal& image, Rounding8 rounding = Rounding8::nearest);

}  // namespace ptm::golden
