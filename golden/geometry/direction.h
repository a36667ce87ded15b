#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

/// Lengths and directions of vectors of any size. A vector's own squares leave the doubles below
/// 1e-154 and above 1e154; scaled by its largest part first, none does. Powers of two scale
/// exactly, so that vectors of usual size keep their results to the last bit.
namespace ptm::golden {

/// The exponent e for which the largest part of `v` is in [2^e, 2^(e + 1)); 0 for (0, 0, 0). `v` is
/// finite.
[[nodiscard]] inline int binary_size(const Eigen::Vector3d& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  return largest > 0 ? std::ilogb(largest) : 0;
}

/// v 2^exponent, in two steps where that power is no double itself.
[[nodiscard]] inline Eigen::Vector3d times_power(const Eigen::Vector3d& v, int exponent) {
  const int half = exponent / 2;
  return v * std::ldexp(1.0, half) * std::ldexp(1.0, exponent - half);
}

/// A positive multiple of `v` whose largest part is in [1, 2); (0, 0, 0) stays. Exact but for parts
/// that are nothing beside the largest.
[[nodiscard]] inline Eigen::Vector3d brought_near_one(const Eigen::Vector3d& v) {
  return times_power(v, -binary_size(v));
}

/// |v|; infinite only if that exceeds the largest double.
[[nodiscard]] inline double length(const Eigen::Vector3d& v) {
  const int size = binary_size(v);
  return std::ldexp(times_power(v, -size).norm(), size);
}

/// v / |v|; (0, 0, 0) stays.
[[nodiscard]] inline Eigen::Vector3d unit(const Eigen::Vector3d& v) {
  return brought_near_one(v).normalized();
}

/// A positive multiple of a x b.
[[nodiscard]] inline Eigen::Vector3d across(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return brought_near_one(a).cross(brought_near_one(b));
}

/// Whether the sine of the angle between two vectors exceeds `least`; false if one is (0, 0, 0).
[[nodiscard]] inline bool span_a_plane(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                       double least) {
  const Eigen::Vector3d near_a = brought_near_one(a), near_b = brought_near_one(b);
  return near_a.cross(near_b).norm() > least * near_a.norm() * near_b.norm();
}

}  // namespace ptm::golden
