#include "golden/scene/mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "golden/geometry/direction.h"
#include "golden/scene/two_stage.h"

namespace ptm::golden {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Positive multiples of dP/du and dP/dv from the gradients of u and v in the plane of `normal`.
void set_directions(const Vec3& normal, const Vec3& edge, SurfacePoint& point) {
  const Vec3 u = brought_near_one(point.gradient_u), v = brought_near_one(point.gradient_v);
  const double area = normal.dot(u.cross(v));
  if (std::abs(area) > 1e-12 * u.norm() * v.norm()) {
    point.along_u = std::copysign(1.0, area) * v.cross(normal);
    point.along_v = std::copysign(1.0, area) * normal.cross(u);
    return;
  }
  point.along_u = u.isZero(0) ? edge : u;
  point.along_v = point.along_u.cross(normal);
}

}  // namespace

ObjMesh Mesh::load(const ObjectSpec& spec) {
  ObjMesh mesh = read_obj(spec.file);
  if (spec.mapping != MeshMapping::own) return mesh;
  for (const ObjTriangle& t : mesh.triangles) {
    for (const ObjCorner& c : t.corners) {
      if (c.texture >= 0) continue;
      throw InputError(spec.file.string(), "line " + std::to_string(t.line),
                       "a face without texture coordinates",
                       "vt at every corner, or a mapping over a surface in the scene");
    }
  }
  return mesh;
}

std::vector<TriangleTree::Corners> Mesh::corners_of(const ObjMesh& mesh) {
  std::vector<TriangleTree::Corners> all;
  for (const ObjTriangle& t : mesh.triangles) {
    TriangleTree::Corners corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh.positions[index(t.corners[k].position)];
    all.push_back(corners);
  }
  return all;
}

Mesh::Mesh(const ObjectSpec& spec)
    : mesh_(load(spec)),
      tree_(corners_of(mesh_)),
      intermediate_(spec.shape),
      mapping_(spec.mapping) {
  const auto triangles = corners_of(mesh_);
  Eigen::AlignedBox3d box;
  for (const auto& c : triangles) {
    for (const Vec3& corner : c) box.extend(corner);
  }
  size_ = length(box.diagonal());
  // Areas in parts of the mesh' size, whose squares may leave the doubles.
  const int size = binary_size(box.diagonal());
  double area = 0;
  for (const auto& c : triangles) {
    const Vec3 e1 = times_power(c[1] - c[0], -size), e2 = times_power(c[2] - c[0], -size);
    const double twice = std::max(e1.cross(e2).norm(), std::numeric_limits<double>::min());
    centroid_ += twice * (c[0] + c[1] + c[2]) / 3;
    area += twice;
  }
  centroid_ /= area;
}

Mesh::Edges Mesh::edges_of(const ObjTriangle& triangle) const {
  Edges e;
  e.origin = mesh_.positions[index(triangle.corners[0].position)];
  e.e1 = mesh_.positions[index(triangle.corners[1].position)] - e.origin;
  e.e2 = mesh_.positions[index(triangle.corners[2].position)] - e.origin;
  const int size1 = binary_size(e.e1), size2 = binary_size(e.e2);
  const Vec3 e1 = times_power(e.e1, -size1), e2 = times_power(e.e2, -size2);
  const Vec3 normal = e1.cross(e2);
  e.normal = normal.normalized();
  e.dual1 = times_power(e2.cross(normal) / normal.squaredNorm(), -size1);
  e.dual2 = times_power(normal.cross(e1) / normal.squaredNorm(), -size2);
  return e;
}

Vec3 Mesh::normal_of(const ObjTriangle& t, const Edges& e, double b1, double b2) const {
  for (const ObjCorner& c : t.corners) {
    if (c.normal < 0) return e.normal;
  }
  const auto corner = [&](std::size_t k) {
    return unit(mesh_.normals[index(t.corners[k].normal)]);
  };
  const Vec3 mixed = (1 - b1 - b2) * corner(0) + b1 * corner(1) + b2 * corner(2);
  return mixed.norm() > 1e-9 ? Vec3(mixed.normalized()) : e.normal;
}

std::array<double, 2> Mesh::texcoord(const ObjCorner& corner) const {
  const auto& vt = mesh_.texcoords[index(corner.texture)];
  return {vt[0], 1 - vt[1]};
}

void Mesh::own_coordinates(const ObjTriangle& t, const Edges& e, double b1, double b2,
                           SurfacePoint& point) const {
  const auto c0 = texcoord(t.corners[0]), c1 = texcoord(t.corners[1]), c2 = texcoord(t.corners[2]);
  const double du1 = c1[0] - c0[0], du2 = c2[0] - c0[0];
  const double dv1 = c1[1] - c0[1], dv2 = c2[1] - c0[1];
  point.u = c0[0] + b1 * du1 + b2 * du2;
  point.v = c0[1] + b1 * dv1 + b2 * dv2;
  point.gradient_u = du1 * e.dual1 + du2 * e.dual2;
  point.gradient_v = dv1 * e.dual1 + dv2 * e.dual2;
}

void Mesh::two_stage(const ObjTriangle& t, const Edges& e, SurfacePoint& point) const {
  const auto coordinates = [&](const Vec3& at) {
    const double b1 = e.dual1.dot(at - e.origin), b2 = e.dual2.dot(at - e.origin);
    return two_stage_coordinates(intermediate_, mapping_, at, normal_of(t, e, b1, b2), centroid_);
  };
  const auto here = coordinates(point.position);
  point.u = here[0];
  point.v = here[1];
  const double step = kStep * size_;
  const Vec3 first = unit(e.e1), second = e.normal.cross(first);
  for (const Vec3& direction : {first, second}) {
    const auto ahead = coordinates(point.position + step * direction);
    const auto behind = coordinates(point.position - step * direction);
    double du = ahead[0] - behind[0];
    if (intermediate_.kind != ShapeKind::plane) du = std::remainder(du, intermediate_.a);
    point.gradient_u += du / (2 * step) * direction;
    point.gradient_v += (ahead[1] - behind[1]) / (2 * step) * direction;
  }
}

SurfacePoint Mesh::at(int triangle, double b1, double b2) const {
  const ObjTriangle& t = mesh_.triangles[index(triangle)];
  const Edges e = edges_of(t);
  SurfacePoint point;
  point.position = e.origin + b1 * e.e1 + b2 * e.e2;
  point.normal = e.normal;
  point.shading = normal_of(t, e, b1, b2);
  if (mapping_ == MeshMapping::own) {
    own_coordinates(t, e, b1, b2, point);
  } else {
    two_stage(t, e, point);
  }
  set_directions(e.normal, e.e1, point);
  return point;
}

}  // namespace ptm::golden
