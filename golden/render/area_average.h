#pragma once
#include "golden/render/texture_filter.h"

namespace ptm::golden {

/// A pixel's footprint: the parallelogram about (u, v) with sides (dudx, dvdx) and (dudy, dvdy).
struct PixelFootprint {
  double u = 0, v = 0;
  double dudx = 0, dvdx = 0, dudy = 0, dvdy = 0;
};

/// The exact mean of level 0's lit texels over a footprint, a texel being constant on its square;
/// the yardstick for filters. Clamped coordinates repeat the edge's texels outwards.
///
/// Each texel weighs by the area of its square within the parallelogram, found by clipping: exact
/// but for rounding (1e-12 of the area). Sampled instead, at the centres of n x n equal parts, are
/// footprints whose box holds more than kMostTexels (n = kGrid) and those of less than kLeastArea
/// of a texel, which are lines or points (n = kLineGrid). Error then at most 255 times the share of
/// the parts that a texel's border crosses: for a line 255 / kLineGrid for each border, to either
/// side alike; where there are more texels than parts it is the noise of kGrid^2 samples of them, s
/// / 256 with s the deviation among texels.
[[nodiscard]] Rgba area_average(const MipTexture& texture, const PixelFootprint& footprint,
                                WrapMode wrap_u, WrapMode wrap_v,
                                const std::array<double, 2>& light);
/// The same of what effects add.
[[nodiscard]] Rgba area_average(const AddendView& texture, const PixelFootprint& footprint,
                                WrapMode wrap_u, WrapMode wrap_v,
                                const std::array<double, 2>& light);
inline constexpr double kMostTexels = 65536;
inline constexpr int kGrid = 256;
inline constexpr double kLeastArea = 1e-9;
inline constexpr int kLineGrid = 64;

}  // namespace ptm::golden
