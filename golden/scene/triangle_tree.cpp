#include "golden/scene/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "golden/geometry/direction.h"

namespace ptm::golden {
namespace {

constexpr std::size_t kLeaf = 4;
constexpr double kWiden = 1e-12;  ///< of an edge, in barycentric coordinates

/// Möller and Trumbore's test, with edges brought to a size near 1: their products stay numbers.
std::optional<TriangleHit> hit(const TriangleTree::Corners& c, const Ray& ray, int index) {
  const Vec3 whole1 = c[1] - c[0], whole2 = c[2] - c[0];
  const int size1 = binary_size(whole1), size2 = binary_size(whole2);
  const Vec3 e1 = times_power(whole1, -size1), e2 = times_power(whole2, -size2);
  const Vec3 across = ray.direction.cross(e2);
  const double determinant = e1.dot(across);
  if (determinant == 0) return std::nullopt;
  const Vec3 from = ray.origin - c[0];
  const double b1 = std::ldexp(from.dot(across) / determinant, -size1);
  const Vec3 other = from.cross(e1);
  const double b2 = std::ldexp(ray.direction.dot(other) / determinant, -size2);
  const double t = e2.dot(other) / determinant;
  const bool inside = b1 >= -kWiden && b2 >= -kWiden && b1 + b2 <= 1 + kWiden;
  if (!inside || !(t > 0) || !std::isfinite(t)) return std::nullopt;
  return TriangleHit{t, index, b1, b2};
}

/// Whether the ray meets the box before `nearest`.
bool meets(const Eigen::AlignedBox3d& box, const Ray& ray, double nearest) {
  double from = 0, to = nearest;
  for (int k = 0; k < 3; ++k) {
    const double d = ray.direction[k], o = ray.origin[k];
    if (d == 0) {
      if (o < box.min()[k] || o > box.max()[k]) return false;
      continue;
    }
    const double a = (box.min()[k] - o) / d, b = (box.max()[k] - o) / d;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to;
}

}  // namespace

TriangleTree::TriangleTree(std::vector<Corners> triangles)
    : triangles_(std::move(triangles)), order_(triangles_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  std::vector<Vec3> centres;
  for (const Corners& c : triangles_) centres.emplace_back((c[0] + c[1] + c[2]) / 3);
  nodes_.push_back({.box = {}, .first = 0, .count = triangles_.size()});
  // Nodes are appended while this runs, so it reaches the children too.
  for (std::size_t n = 0; n < nodes_.size(); ++n) split(n, centres);
}

void TriangleTree::split(std::size_t node, std::vector<Vec3>& centres) {
  const std::size_t first = nodes_[node].first, count = nodes_[node].count;
  Eigen::AlignedBox3d box, middle;
  for (std::size_t i = first; i < first + count; ++i) {
    const auto t = static_cast<std::size_t>(order_[i]);
    for (const Vec3& corner : triangles_[t]) box.extend(corner);
    middle.extend(centres[t]);
  }
  // A flat box must not lose its hits to rounding.
  const Vec3 margin = Vec3::Constant(1e-9 * length(box.diagonal()));
  nodes_[node].box = {box.min() - margin, box.max() + margin};
  if (count <= kLeaf) return;
  Eigen::Index axis = 0;
  middle.diagonal().maxCoeff(&axis);
  const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(first);
  const std::size_t half = count / 2;
  std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(half),
                   begin + static_cast<std::ptrdiff_t>(count), [&](int a, int b) {
                     return centres[static_cast<std::size_t>(a)][axis] <
                            centres[static_cast<std::size_t>(b)][axis];
                   });
  nodes_[node] = {.box = nodes_[node].box, .first = nodes_.size(), .count = 0};
  nodes_.push_back({.box = {}, .first = first, .count = half});
  nodes_.push_back({.box = {}, .first = first + half, .count = count - half});
}

std::optional<TriangleHit> TriangleTree::intersect(const Ray& ray) const {
  std::optional<TriangleHit> best;
  std::vector<std::size_t> open{0};
  while (!open.empty()) {
    const Node& node = nodes_[open.back()];
    open.pop_back();
    if (!meets(node.box, ray, best ? best->t : std::numeric_limits<double>::infinity())) continue;
    if (node.count == 0) {
      open.push_back(node.first);
      open.push_back(node.first + 1);
      continue;
    }
    for (std::size_t i = node.first; i < node.first + node.count; ++i) {
      const auto found = hit(triangles_[static_cast<std::size_t>(order_[i])], ray, order_[i]);
      if (!found) continue;
      const bool nearer =
          !best || found->t < best->t || (found->t == best->t && found->triangle < best->triangle);
      if (nearer) best = found;
    }
  }
  return best;
}

}  // namespace ptm::golden
