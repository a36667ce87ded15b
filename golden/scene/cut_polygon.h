#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "golden/scene/shape.h"

namespace ptm::golden {

/// Cuts a polygon, convex or not, into triangles by clipping ears; indices into `corners`, turning
/// as the polygon does. Only the cyclic order of the corners counts as long as `first` is the same
/// corner: the cuts do not depend on where the list begins. A corner may lie a little outside the
/// polygon's plane: it is judged as seen along Newell's normal. What remains of a polygon that
/// crosses itself, and so has no ear, becomes a fan. Requires three corners or more.
[[nodiscard]] std::vector<std::array<std::size_t, 3>> cut_polygon(const std::vector<Vec3>& corners,
                                                                  std::size_t first = 0);

}  // namespace ptm::golden
