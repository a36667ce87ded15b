#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "golden/files/ptm_map.h"
#include "golden/fit/light_solver.h"
#include "golden/fit/near_lights.h"
#include "golden/fit/photo_bands.h"

namespace ptm::golden {

enum class ColorRule : std::uint8_t {
  least_squares,  ///< HP's: the colour whose product with the luminance is nearest the photographs
  average         ///< the hue of the photographs' average
};

/// Colour times luminance says only what their product is; this says which of the two is as large
/// as its byte allows, texel by texel.
enum class FullRange : std::uint8_t {
  color,     ///< the brightest channel is 255: rounding the colour costs least
  luminance  ///< HP's: the brightest luminance of the photographs is 255
};

struct FitOptions {
  MapKind kind = MapKind::lrgb;
  ColorRule color = ColorRule::least_squares;  ///< lrgb only
  int robust_passes = 0;                       ///< reweighted passes; 0 is plain least squares
  FullRange full_range = FullRange::color;     ///< lrgb only
  bool truncate_color = false;                 ///< lrgb only: as HP's fitter does, not rounded
};

/// Weights of red, green and blue in an LRGB map's luminance (Rec. 709, as HP's fitter has them).
inline constexpr std::array<double, 3> kLumaWeights{0.2125, 0.7154, 0.0721};

/// What the polynomials are fitted to, as sums of red, green and blue: the luminance of HP's recipe
/// (lrgb), Y of JFIF (lum), or the three channels (rgb).
[[nodiscard]] std::vector<std::array<double, 3>> fitted_signals(MapKind kind);

/// Fits some texels: docs/spec/fit.md, F2 to F5. The formulas, with y_i the luminance of light i:
///
///     lrgb   color = clamp(k c, 0, 255),  a = 255 inverse * y / k
///            least_squares: c = sum_i rgb_i y_i / sum_i y_i^2
///            average:       c = mean rgb / mean y
///            full range of color:     k = 255 / max c, or max y / 4 if that is more
///            full range of luminance: k = max y, for average 255 / max c if that is less
///     rgb    a_c = inverse * c                     for each channel c
///     lum    a   = inverse * Y,  Cr and Cb the photographs' averages
///
/// Robust passes reweigh the lights of each texel: w_i = 1 / (1 + (r_i / (2.3849 s))^2), Cauchy's
/// weights of 95 % efficiency, s = max(1.4826 median |r|, 1/2 level); they never reach zero, so the
/// system stays solvable. The colour of lrgb is weighted alike.
///
/// A texel black in every photograph gets coefficients 0 and colour 0 (lum: 128, 128).
///
/// With `near` lights, the formulas hold for samples divided by each light's strength at the texel,
/// and inverse is the texel's own (near_lights.h); `solver` is of the picture's centre.
///
/// Writes coef [texel][polynomials][6] and color [texel][PtmMap::color_bytes()].
void fit_tile(const PhotoTile& tile, const LightSolver& solver, const FitOptions& options,
              std::span<double> coef, std::span<std::uint8_t> color, NearTexels near = {});

}  // namespace ptm::golden
