#include "golden/scene/two_stage.h"

#include <cmath>
#include <limits>

#include "golden/geometry/direction.h"

namespace ptm::golden {
namespace {

/// Where the line from + t direction meets the whole surface: the largest t >= 0, else the largest
/// of all.
std::optional<Vec3> project(const Shape& shape, const Vec3& from, const Vec3& along) {
  const Vec3 direction = brought_near_one(along);
  if (shape.kind == ShapeKind::plane) {
    const Vec3 normal = across(shape.axis_i, shape.axis_j);
    const double slope = normal.dot(direction);
    // A line that all but runs along the plane would land anywhere.
    if (std::abs(slope) <= 1e-9 * normal.norm() * direction.norm()) return std::nullopt;
    return from + normal.dot(shape.origin - from) / slope * direction;
  }
  Vec3 o = from - shape.origin, d = direction;
  if (shape.kind == ShapeKind::cylinder) o.z() = d.z() = 0;
  const double a = d.squaredNorm(), b = o.dot(d);
  const double discriminant = b * b - a * (o.squaredNorm() - shape.radius * shape.radius);
  if (a <= 1e-18 * direction.squaredNorm() || !(discriminant >= 0)) return std::nullopt;
  // The greater root is the farthest hit ahead; with none ahead both lie behind and it is nearest.
  return from + (-b + std::sqrt(discriminant)) / a * direction;
}

std::array<double, 2> coordinates_of(const Shape& shape, const Vec3& point) {
  const Vec3 d = point - shape.origin;
  if (shape.kind == ShapeKind::plane) {
    const auto [p, q] = plane_parameters(shape, d);
    return coordinates_at(shape, p, q);
  }
  const double radial = std::hypot(d.x(), d.y());
  const double theta =
      radial > 0 ? turned_to(std::atan2(d.y(), d.x()), shape.p_range[0]) : shape.p_range[0];
  const double q = shape.kind == ShapeKind::cylinder ? d.z() : std::atan2(radial, d.z());
  return coordinates_at(shape, theta, q);
}

}  // namespace

std::array<double, 2> two_stage_coordinates(const Shape& intermediate, MeshMapping mapping,
                                            const Vec3& point, const Vec3& normal,
                                            const Vec3& centroid) {
  std::optional<Vec3> hit;
  if (mapping == MeshMapping::object_normal) hit = project(intermediate, point, normal);
  if (mapping == MeshMapping::centroid) hit = project(intermediate, point, point - centroid);
  // Perpendicular to any of the three surfaces, a point keeps the angles and the height it has.
  return coordinates_of(intermediate, hit.value_or(point));
}

}  // namespace ptm::golden
