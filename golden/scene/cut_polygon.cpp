#include "golden/scene/cut_polygon.h"

#include <algorithm>
#include <cmath>

#include "golden/geometry/direction.h"

namespace ptm::golden {
namespace {

using Point = std::array<double, 2>;

Vec3 newell_normal(const std::vector<Vec3>& corners) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 a = corners[i] - corners[0], b = corners[(i + 1) % corners.size()] - corners[0];
    sum += a.cross(b);
  }
  return sum;
}

/// The corners without the coordinate in which the normal is longest, anticlockwise.
std::vector<Point> flattened(std::vector<Vec3> corners) {
  // Areas are products of lengths: of a face brought to a size near 1 they stay numbers.
  Eigen::AlignedBox3d box;
  for (const Vec3& corner : corners) box.extend(corner);
  const int size = binary_size(box.diagonal());
  for (Vec3& corner : corners) corner = times_power(corner - box.min(), -size);
  const Vec3 normal = newell_normal(corners);
  Eigen::Index dropped = 0;
  normal.cwiseAbs().maxCoeff(&dropped);
  Eigen::Index x = (dropped + 1) % 3, y = (dropped + 2) % 3;
  if (normal[dropped] < 0) std::swap(x, y);
  std::vector<Point> flat;
  for (const Vec3& corner : corners) {
    flat.push_back({corner[x] - corners[0][x], corner[y] - corners[0][y]});
  }
  return flat;
}

/// Twice the area of a triangle, positive if anticlockwise.
double area(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Within the triangle or on its border; a corner in the same place as one of the triangle's does
/// not count, as where a hole is joined to its outline.
bool covers(const Point& a, const Point& b, const Point& c, const Point& p) {
  if (p == a || p == b || p == c) return false;
  return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
}

}  // namespace

std::vector<std::array<std::size_t, 3>> cut_polygon(const std::vector<Vec3>& corners,
                                                    std::size_t first) {
  const std::vector<Point> flat = flattened(corners);
  std::vector<std::size_t> left(corners.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = (first + i) % corners.size();
  std::vector<std::array<std::size_t, 3>> triangles;
  const auto around = [&](std::size_t i) {
    return std::array<std::size_t, 3>{left[(i + left.size() - 1) % left.size()], left[i],
                                      left[(i + 1) % left.size()]};
  };
  const auto size_of = [&](const std::array<std::size_t, 3>& t) {
    return area(flat[t[0]], flat[t[1]], flat[t[2]]);
  };
  const auto is_ear = [&](const std::array<std::size_t, 3>& t) {
    return size_of(t) > 0 && std::none_of(left.begin(), left.end(), [&](std::size_t k) {
             return covers(flat[t[0]], flat[t[1]], flat[t[2]], flat[k]);
           });
  };
  while (left.size() > 3) {
    // From the second corner on, so that a convex polygon becomes a fan around its first one.
    std::size_t ear = 0;
    std::size_t n = 0;
    while (n < left.size() && !is_ear(around(ear = (n + 1) % left.size()))) ++n;
    if (n == left.size()) {
      for (n = 0; n < left.size() && size_of(around(ear = (n + 1) % left.size())) != 0;) ++n;
    }
    if (n == left.size()) break;
    triangles.push_back(around(ear));
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  for (std::size_t i = 2; i < left.size(); ++i) {
    triangles.push_back({left[0], left[i - 1], left[i]});
  }
  return triangles;
}

}  // namespace ptm::golden
