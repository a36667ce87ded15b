#include "golden/scene/placed_object.h"

#include <algorithm>
#include <cmath>

namespace ptm::golden {
namespace {

Eigen::Matrix3d linear_part(const TransformSpec& transform) {
  const Vec3 angles = transform.rotate * (std::numbers::pi / 180);
  const Eigen::Matrix3d turned =
      (Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
       Eigen::AngleAxisd(angles.x(), Vec3::UnitX()))
          .toRotationMatrix();
  return turned * transform.scale.asDiagonal();
}

/// Which of `cells` cells of a range holds a value, and where in it, 0..1.
struct Cell {
  double low = 0, high = 0, part = 0;
};
Cell cell_of(double value, const std::array<double, 2>& range, int cells) {
  const double width = (range[1] - range[0]) / cells;
  const double n = std::clamp(std::floor((value - range[0]) / width), 0.0, cells - 1.0);
  const double low = range[0] + n * width;
  return {low, low + width, (value - low) / width};
}

}  // namespace

PlacedObject::PlacedObject(const ObjectSpec& spec)
    : spec_(spec),
      mesh_(spec.mesh ? std::make_unique<Mesh>(spec) : nullptr),
      to_world_(linear_part(spec.transform)),
      to_object_(to_world_.inverse()) {}

std::optional<ObjectHit> PlacedObject::intersect(const Ray& ray) const {
  const Ray own{to_object_ * (ray.origin - spec_.transform.translate), to_object_ * ray.direction};
  if (mesh_) {
    const auto hit = mesh_->intersect(own);
    if (!hit) return std::nullopt;
    return ObjectHit{hit->t, {hit->triangle, hit->b1, hit->b2}};
  }
  const auto hit = golden::intersect(spec_.shape, own);
  if (!hit) return std::nullopt;
  return ObjectHit{hit->t, {-1, hit->p, hit->q}};
}

SurfacePoint PlacedObject::at(const SurfacePlace& place) const {
  SurfacePoint point =
      mesh_ ? mesh_->at(place.triangle, place.s, place.t) : point_at(spec_.shape, place.s, place.t);
  // Normals and gradients are covectors.
  const Eigen::Matrix3d dual = to_object_.transpose();
  point.position = to_world_ * point.position + spec_.transform.translate;
  point.normal = (dual * point.normal).normalized();
  point.shading = (dual * point.shading).normalized();
  point.along_u = to_world_ * point.along_u;
  point.along_v = to_world_ * point.along_v;
  point.gradient_u = dual * point.gradient_u;
  point.gradient_v = dual * point.gradient_v;
  return point;
}

std::array<WeightedCorner, 3> PlacedObject::corners(const SurfacePlace& place) const {
  if (mesh_) {
    const int n = place.triangle;
    return {{{{n, 0, 0}, 1 - place.s - place.t}, {{n, 1, 0}, place.s}, {{n, 0, 1}, place.t}}};
  }
  const Cell p = cell_of(place.s, spec_.shape.p_range, spec_.segments[0]);
  const Cell q = cell_of(place.t, spec_.shape.q_range, spec_.segments[1]);
  const WeightedCorner low{{-1, p.low, q.low}, 1 - std::max(p.part, q.part)};
  const WeightedCorner high{{-1, p.high, q.high}, std::min(p.part, q.part)};
  if (p.part >= q.part) return {{low, {{-1, p.high, q.low}, p.part - q.part}, high}};
  return {{low, {{-1, p.low, q.high}, q.part - p.part}, high}};
}

std::optional<double> PlacedObject::turn() const {
  const bool shaped = !spec_.mesh || spec_.mapping != MeshMapping::own;
  if (!shaped || spec_.shape.kind == ShapeKind::plane) return std::nullopt;
  return std::abs(spec_.shape.a);
}

}  // namespace ptm::golden
