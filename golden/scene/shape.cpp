#include "golden/scene/shape.h"

#include <algorithm>
#include <cmath>

#include "golden/geometry/direction.h"

namespace ptm::golden {
namespace {

constexpr double kPi = std::numbers::pi;

bool inside(double value, const std::array<double, 2>& range) {
  return value >= range[0] && value <= range[1];
}

/// The parameters of a point of the surface.
std::array<double, 2> parameters_of(const Shape& shape, const Vec3& point) {
  const Vec3 d = point - shape.origin;
  const double theta = turned_to(std::atan2(d.y(), d.x()), shape.p_range[0]);
  if (shape.kind == ShapeKind::cylinder) return {theta, d.z()};
  // atan2 keeps its precision at the poles, where acos has none.
  return {theta, std::atan2(std::hypot(d.x(), d.y()), d.z())};
}

std::optional<ShapeHit> intersect_plane(const Shape& shape, const Ray& ray) {
  const Vec3 normal = across(shape.axis_i, shape.axis_j);
  const double slope = normal.dot(ray.direction);
  if (slope == 0) return std::nullopt;
  const double t = normal.dot(shape.origin - ray.origin) / slope;
  const auto [s, q] = plane_parameters(shape, ray.origin + t * ray.direction - shape.origin);
  if (!(t > 0) || !inside(s, shape.p_range) || !inside(q, shape.q_range)) return std::nullopt;
  return ShapeHit{t, s, q};
}

/// Both roots of a t^2 + 2 b t + c, ascending; without cancellation.
std::optional<std::array<double, 2>> roots(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (a == 0 || !(discriminant >= 0)) return std::nullopt;
  const double far = -(b + std::copysign(std::sqrt(discriminant), b));
  if (far == 0) return std::array<double, 2>{0, 0};
  const double x = far / a, y = c / far;
  return std::array<double, 2>{std::min(x, y), std::max(x, y)};
}

std::optional<ShapeHit> intersect_round(const Shape& shape, const Ray& ray) {
  Vec3 o = ray.origin - shape.origin, d = ray.direction;
  if (shape.kind == ShapeKind::cylinder) o.z() = d.z() = 0;
  const auto ts = roots(d.squaredNorm(), o.dot(d), o.squaredNorm() - shape.radius * shape.radius);
  if (!ts) return std::nullopt;
  for (const double t : *ts) {
    if (!(t > 0)) continue;
    const auto [p, q] = parameters_of(shape, ray.origin + t * ray.direction);
    if (inside(p, shape.p_range) && inside(q, shape.q_range)) return ShapeHit{t, p, q};
  }
  return std::nullopt;
}

/// The gradients of p and q along a plane: the dual of its axes.
std::array<Vec3, 2> plane_gradients(const Shape& shape) {
  const int size_i = binary_size(shape.axis_i), size_j = binary_size(shape.axis_j);
  const Vec3 i = times_power(shape.axis_i, -size_i), j = times_power(shape.axis_j, -size_j);
  const Vec3 normal = i.cross(j);
  const double area = normal.squaredNorm();
  return {times_power(j.cross(normal) / area, -size_i),
          times_power(normal.cross(i) / area, -size_j)};
}

SurfacePoint plane_at(const Shape& shape, double p, double q) {
  SurfacePoint point;
  point.position = shape.origin + p * shape.axis_i + q * shape.axis_j;
  point.normal = across(shape.axis_i, shape.axis_j).normalized();
  point.along_u = shape.axis_i;
  point.along_v = shape.axis_j;
  const auto [along_p, along_q] = plane_gradients(shape);
  point.gradient_u = along_p;
  point.gradient_v = along_q;
  return point;
}

}  // namespace

std::array<double, 2> plane_parameters(const Shape& plane, const Vec3& d) {
  const int size_i = binary_size(plane.axis_i), size_j = binary_size(plane.axis_j);
  const Vec3 i = times_power(plane.axis_i, -size_i), j = times_power(plane.axis_j, -size_j);
  const Vec3 normal = i.cross(j);
  const double area = normal.squaredNorm();
  return {std::ldexp(d.cross(j).dot(normal) / area, -size_i),
          std::ldexp(i.cross(d).dot(normal) / area, -size_j)};
}

double turned_to(double angle, double from) {
  const double turn = 2 * kPi;
  const double moved = angle - turn * std::floor((angle - from) / turn);
  return moved >= from + turn ? moved - turn : moved;
}

Shape whole_shape(ShapeKind kind, double height) {
  Shape shape;
  shape.kind = kind;
  if (kind == ShapeKind::plane) {
    shape.origin = Vec3(-1, 0, 1);
    shape.axis_i = Vec3(2, 0, 0);
    shape.axis_j = Vec3(0, 0, -2);
    return shape;
  }
  shape.p_range = {0, 2 * kPi};
  shape.q_range = {0, kind == ShapeKind::sphere ? kPi : height};
  if (kind == ShapeKind::cylinder) {
    shape.origin = Vec3(0, 0, -height / 2);
    shape.height = shape.q0 = height;
    shape.b = -1;
  }
  return shape;
}

std::array<double, 2> coordinates_at(const Shape& shape, double p, double q) {
  if (shape.kind == ShapeKind::plane) return {p, q};
  const double span = shape.kind == ShapeKind::cylinder ? shape.height : kPi;
  return {shape.a * (p - shape.p0) / (2 * kPi), shape.b * (q - shape.q0) / span};
}

SurfacePoint point_at(const Shape& shape, double p, double q) {
  SurfacePoint point;
  if (shape.kind == ShapeKind::plane) {
    point = plane_at(shape, p, q);
  } else {
    const double r = shape.radius;
    const Vec3 east(-std::sin(p), std::cos(p), 0);
    const bool round = shape.kind == ShapeKind::sphere;
    const double sine = round ? std::sin(q) : 1, cosine = round ? std::cos(q) : 0;
    point.normal = Vec3(std::cos(p) * sine, std::sin(p) * sine, cosine);
    point.position = shape.origin + r * point.normal + (round ? Vec3(0, 0, 0) : Vec3(0, 0, q));
    const Vec3 along_q =
        round ? Vec3(std::cos(p) * cosine, std::sin(p) * cosine, -sine) : Vec3(0, 0, 1);
    point.along_u = std::copysign(1.0, shape.a) * east;
    point.along_v = std::copysign(1.0, shape.b) * along_q;
    point.gradient_u = shape.a / (2 * kPi * r * std::max(std::abs(sine), kPoleSine)) * east;
    point.gradient_v = shape.b / (round ? kPi * r : shape.height) * along_q;
  }
  point.shading = point.normal;
  const auto [u, v] = coordinates_at(shape, p, q);
  point.u = u;
  point.v = v;
  return point;
}

std::optional<ShapeHit> intersect(const Shape& shape, const Ray& ray) {
  return shape.kind == ShapeKind::plane ? intersect_plane(shape, ray) : intersect_round(shape, ray);
}

}  // namespace ptm::golden
