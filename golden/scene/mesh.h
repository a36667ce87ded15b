#pragma once
#include <optional>

#include "golden/scene/obj_file.h"
#include "golden/scene/triangle_tree.h"
#include "golden/scene/unit_scene.h"

namespace ptm::golden {

/// A triangle mesh with texture coordinates, in its own space.
class Mesh {
 public:
  /// Throws InputError (read_obj; a face without vt where the mapping is the OBJ's own).
  explicit Mesh(const ObjectSpec& spec);

  [[nodiscard]] std::optional<TriangleHit> intersect(const Ray& ray) const {
    return tree_.intersect(ray);
  }

  /// The surface at weights b1, b2 of a triangle's second and third corner.
  ///
  /// Own coordinates are interpolated; v runs down, 1 - vt's. Two-stage ones are found at the point
  /// itself, their gradients by central differences of `kStep` mesh sizes in the triangle's plane,
  /// where the step from one turn to the next is taken off. Triangles on which u and v do not
  /// differ get a frame along their first edge.
  [[nodiscard]] SurfacePoint at(int triangle, double b1, double b2) const;
  static constexpr double kStep = 1e-5;

 private:
  struct Edges {
    Vec3 origin, e1, e2, normal, dual1, dual2;  ///< db_k = dual_k . dP in the triangle's plane
  };
  [[nodiscard]] Edges edges_of(const ObjTriangle& triangle) const;
  [[nodiscard]] Vec3 normal_of(const ObjTriangle& t, const Edges& e, double b1, double b2) const;
  [[nodiscard]] std::array<double, 2> texcoord(const ObjCorner& corner) const;
  void own_coordinates(const ObjTriangle& t, const Edges& e, double b1, double b2,
                       SurfacePoint& point) const;
  void two_stage(const ObjTriangle& t, const Edges& e, SurfacePoint& point) const;

  static ObjMesh load(const ObjectSpec& spec);
  static std::vector<TriangleTree::Corners> corners_of(const ObjMesh& mesh);

  ObjMesh mesh_;
  TriangleTree tree_;
  Shape intermediate_;
  MeshMapping mapping_;
  Vec3 centroid_{0, 0, 0};  ///< of the surface: triangles weighed by area
  double size_ = 1;         ///< diagonal of the bounding box
};

}  // namespace ptm::golden
