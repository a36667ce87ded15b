#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "model/quantize/maps.h"

namespace ptm::quantize {

/// A level's side from the one above.
[[nodiscard]] constexpr int half_side(int side) { return std::max(1, side / 2); }

/// Half the size by averages: [height][width][channels] to
/// [half_side(height)][half_side(width)][channels].
///
/// A texel of n / 2 covers n / (n / 2) texels of n: two, or where n is odd a little more, the outer
/// ones in part. Each is weighed by the area covered, so the mean of the whole is kept whatever the
/// size. Sizes that are not positive or do not agree throw std::invalid_argument.
[[nodiscard]] std::vector<double> halve(std::span<const double> values, int width, int height,
                                        int channels);

/// One level of real coefficients that owns them.
struct RealLevel {
  int width = 0;
  int height = 0;
  int polynomials = 1;
  std::vector<double> coef;  ///< [height][width][polynomials][6]

  [[nodiscard]] RealMap view() const {
    return {.width = width, .height = height, .polynomials = polynomials, .coef = coef};
  }
};

/// The levels below a map, half the size each, down to 1 x 1; none for a map of 1 x 1.
///
/// Averaging coefficients averages luminance, since it is linear in them (Polynomial Texture Maps,
/// Eq. 14), as long as it is not clamped at 0 in between. Levels are averages, so they lie within
/// the range of the map and its bias and shift hold them: quantize_on_grid() with the map's grid.
[[nodiscard]] std::vector<RealLevel> mip_levels(const RealMap& map);

}  // namespace ptm::quantize
