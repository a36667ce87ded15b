#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "golden/scene/shape.h"

namespace ptm::golden {

struct TriangleHit {
  double t = 0;  ///< along the ray, in lengths of its direction; > 0
  int triangle = -1;
  double b1 = 0, b2 = 0;  ///< weights of the second and third corner
};

/// Triangles in a tree of boxes, to find the nearest along a ray.
class TriangleTree {
 public:
  using Corners = std::array<Vec3, 3>;
  explicit TriangleTree(std::vector<Corners> triangles);

  /// The nearest hit from either side. Edges are a hair wider than they are, so that no ray slips
  /// through between two triangles; of hits at equal distance the lower index wins.
  [[nodiscard]] std::optional<TriangleHit> intersect(const Ray& ray) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    std::size_t first = 0, count = 0;  ///< count 0: children are first and first + 1
  };
  void split(std::size_t node, std::vector<Vec3>& centres);

  std::vector<Corners> triangles_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace ptm::golden
