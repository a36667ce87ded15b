#pragma once
#include <cstddef>

#include "golden/files/image.h"
#include "golden/files/ptm_map.h"
#include "golden/scene/scene.h"

namespace ptm::golden {

/// What the geometry asks of the texture unit at one pixel, in double precision.
struct Sample {
  double u = 0, v = 0;    ///< texture coordinates, 1.0 is the map's width or height; v runs down
  double lu = 0, lv = 0;  ///< light
};

/// A map seen square-on and filling the picture: pixel centres spread evenly over it.
///
///     u = (x + 1/2) / width, v = (y + 1/2) / height
[[nodiscard]] Sample flat_sample(int x, int y, int width, int height, const Light& light);

/// The texel that holds the sample, as point_texel() finds it: floor(u W), floor(v H); u and v in
/// [0, 1).
[[nodiscard]] std::size_t nearest_texel(const PtmMap& map, const Sample& sample);

/// The golden picture of a flat map under one light, [height][width][3], point sampled.
[[nodiscard]] ImageReal render_flat(const PtmMap& map, int width, int height, const Light& light);

}  // namespace ptm::golden
