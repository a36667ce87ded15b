#pragma once
#include <array>

#include "golden/scene/shape.h"
#include "golden/scene/unit_scene.h"

namespace ptm::golden {

/// The slides' two-stage mapping: a point of an object goes to a point of the intermediate surface
/// and gets that one's coordinates. The intermediate is whole: its ranges do not limit it, but
/// theta starts at p_range[0], so that the seam lies there.
///
///     surface_normal  foot of the perpendicular on the plane; radially on cylinder and sphere
///     object_normal   along `normal` from the point: the farthest hit ahead, else the nearest
///                     behind; a line that misses takes surface_normal's way
///     centroid        along the line from `centroid` through the point, likewise
///
/// Returns (u, v). Points on the axis of a cylinder or sphere get theta = p_range[0].
[[nodiscard]] std::array<double, 2> two_stage_coordinates(const Shape& intermediate,
                                                          MeshMapping mapping, const Vec3& point,
                                                          const Vec3& normal, const Vec3& centroid);

}  // namespace ptm::golden
