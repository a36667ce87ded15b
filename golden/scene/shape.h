#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <numbers>
#include <optional>

/// The slides' three surfaces and their parameterisations (Image Texture Fundamentals).
namespace ptm::golden {

using Vec3 = Eigen::Vector3d;

enum class ShapeKind : std::uint8_t { plane, cylinder, sphere };

/// A surface, or a part of it, with texture coordinates. Its two parameters are p and q:
///
///     plane     P = origin + p i + q j                            (u, v) = (p, q)
///     cylinder  P = origin + (r cos p, r sin p, q)                 u = a (p - theta0) / 2 pi
///                                                                  v = b (q - z0) / h
///     sphere    P = origin + r (cos p sin q, sin p sin q, cos q)   u = a (p - theta0) / 2 pi
///                                                                  v = b (q - phi0) / pi
///
/// v runs down in a texture. So that a picture stands upright, j points down by default, and the
/// cylinder's defaults are b = -1, z0 = h: v = 0 at the top.
struct Shape {
  ShapeKind kind = ShapeKind::plane;
  Vec3 origin{0, 0, 0};                    ///< corner, centre of the base, centre
  Vec3 axis_i{1, 0, 0}, axis_j{0, -1, 0};  ///< plane only; not on a line
  double radius = 1;                       ///< > 0
  double height = 1;                       ///< cylinder only; > 0
  double a = 1, b = 1, p0 = 0, q0 = 0;     ///< p0 is theta0 (radians), q0 is z0 or phi0
  std::array<double, 2> p_range{0, 1};     ///< s; theta in radians, at most a turn
  std::array<double, 2> q_range{0, 1};     ///< t; z within the height; phi within 0..pi
  bool operator==(const Shape&) const = default;
};

/// A whole surface of that kind about the world's origin, z up: a square of side 2 that faces -y, a
/// cylinder or sphere of radius 1.
[[nodiscard]] Shape whole_shape(ShapeKind kind, double height = 2);

/// A surface around a point, in the surface's own space.
struct SurfacePoint {
  Vec3 position{0, 0, 0};
  Vec3 normal{0, 0, 1};   ///< unit length; of the geometry, outward
  Vec3 shading{0, 0, 1};  ///< unit length; a mesh's interpolated normal, else the same
  double u = 0, v = 0;
  Vec3 along_u{1, 0, 0};  ///< some positive multiple of dP/du, in the tangent plane
  Vec3 along_v{0, 1, 0};  ///< likewise of dP/dv
  Vec3 gradient_u{0, 0, 0}, gradient_v{0, 0, 0};  ///< du = gradient_u . dP in the tangent plane
};

/// The surface at parameters p, q; at a sphere's pole the limit along its meridian p. Gradients
/// there are finite: |sin q| counts as at least kPoleSine.
[[nodiscard]] SurfacePoint point_at(const Shape& shape, double p, double q);
inline constexpr double kPoleSine = 1e-6;

/// Texture coordinates of parameters.
[[nodiscard]] std::array<double, 2> coordinates_at(const Shape& shape, double p, double q);

struct Ray {
  Vec3 origin{0, 0, 0}, direction{0, 0, -1};
};
struct ShapeHit {
  double t = 0;         ///< along the ray, in lengths of its direction; > 0
  double p = 0, q = 0;  ///< within the shape's ranges
};
/// The nearest hit of the part that the ranges leave, from either side.
[[nodiscard]] std::optional<ShapeHit> intersect(const Shape& shape, const Ray& ray);

/// p and q of the plane's point nearest to origin + d.
[[nodiscard]] std::array<double, 2> plane_parameters(const Shape& plane, const Vec3& d);

/// An angle moved by whole turns into [from, from + 2 pi).
[[nodiscard]] double turned_to(double angle, double from);

}  // namespace ptm::golden
