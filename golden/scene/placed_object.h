#pragma once
#include <array>
#include <memory>
#include <optional>

#include "golden/scene/mesh.h"
#include "golden/scene/shape.h"
#include "golden/scene/unit_scene.h"

namespace ptm::golden {

/// A point of an object: parameters p, q of a shape, or a triangle and two weights.
struct SurfacePlace {
  int triangle = -1;
  double s = 0, t = 0;
};
struct ObjectHit {
  double t = 0;
  SurfacePlace place;
};
/// A corner of the triangle that light is interpolated over, and its weight.
struct WeightedCorner {
  SurfacePlace place;
  double weight = 0;
};

/// An object of a scene, moved to its place in the world.
class PlacedObject {
 public:
  /// Throws InputError from a mesh's file.
  explicit PlacedObject(const ObjectSpec& spec);

  /// Nearest hit of a ray of the world.
  [[nodiscard]] std::optional<ObjectHit> intersect(const Ray& ray) const;
  /// The surface there, in the world; u and v without uv_scale and uv_offset.
  [[nodiscard]] SurfacePoint at(const SurfacePlace& place) const;
  /// The triangle of the tessellation that holds a place; weights add up to 1.
  [[nodiscard]] std::array<WeightedCorner, 3> corners(const SurfacePlace& place) const;
  /// The most that u changes over the whole surface where it goes round, else none.
  [[nodiscard]] std::optional<double> turn() const;
  [[nodiscard]] const ObjectSpec& spec() const { return spec_; }

 private:
  ObjectSpec spec_;
  std::unique_ptr<Mesh> mesh_;
  Eigen::Matrix3d to_world_, to_object_;
};

}  // namespace ptm::golden
