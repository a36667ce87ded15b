#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "golden/fit/fit_tile.h"

namespace ptm::golden {

/// Sums of squared differences, in levels, of red, green and blue.
using Squares = std::array<double, 3>;

/// Distance between a map's rendering and one photograph or all of them, in levels.
struct Residual {
  double rmse = 0;
  double psnr_db = 0;  ///< 20 log10(255 / rmse); infinite if nothing differs
  std::array<double, 3> channel_rmse{}, channel_psnr_db{};  ///< red, green, blue
};
[[nodiscard]] Residual to_residual(const Squares& squares, double samples_per_channel);

/// Renders texels under each light and compares with the photographs; adds to squares [light].
///
///     lrgb  clamp(rgb * L / 255, 0, 255)    rgb  clamp(L_c, 0, 255)
///     lum   clamp(matrix * (Cr, Y, Cb, 1), 0, 255), matrix of JFIF      each channel, not rounded
///
/// With near lights, directions are each texel's own, and each channel is multiplied by the light's
/// strength there before it is clamped: what a photograph shows.
///
/// The tile holds as many photographs as there are directions. `texel_squares`, if not empty, gets
/// each texel's sum over lights and channels added. Wrong sizes throw std::invalid_argument.
void add_squares(const PhotoTile& tile, std::span<const std::array<double, 3>> directions,
                 MapKind kind, std::span<const double> coef, std::span<const std::uint8_t> color,
                 std::span<Squares> squares, std::span<double> texel_squares = {},
                 NearTexels near = {});

/// Adds the squared leave-one-out residuals of a plain least-squares fit, a light each, summed over
/// texels and over the fitted signals (fitted_signals()):  (y_i - b_i . a) / (1 - h_i),
/// which is what a fit without light i misses it by; no fit is repeated. With near lights, the
/// residuals are of samples without fall-off and multiplied by it again: in the photographs'
/// levels.
void add_leave_one_out(const PhotoTile& tile, const LightSolver& solver, MapKind kind,
                       std::span<double> squares, NearTexels near = {});

/// Whether the other lights say anything about this one (1 - h_i above rounding).
[[nodiscard]] bool has_leave_one_out(const LightSolver& solver, std::size_t light);

}  // namespace ptm::golden
