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
/// but for rounding (1e-12 of the area). A footprint whose box holds more than kMostTexels, or of
/// less than 1e-9 of a texel's area, is sampled at the centres of kGrid x kGrid equal parts
/// instead; a part that a texel's border crosses may then be counted whole for one side, an error
/// of at most 255 times their share, and of none for the thin footprint's short side.
[[nodiscard]] Rgba area_average(const MipTexture& texture, const PixelFootprint& footprint,
                                WrapMode wrap_u, WrapMode wrap_v,
                                const std::array<double, 2>& light);
inline constexpr double kMostTexels = 65536;
inline constexpr int kGrid = 256;

}  // namespace ptm::golden
