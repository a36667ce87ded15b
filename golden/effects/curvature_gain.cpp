#include "golden/effects/curvature_gain.h"

#include <Eigen/Eigenvalues>

namespace ptm::golden {
namespace {

/// The part of a quadratic form that bends downwards.
std::array<double, 3> downwards(const Coefficients& a) {
  Eigen::Matrix2d form;
  form << a[0], a[2] / 2, a[2] / 2, a[1];
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(form);
  const Eigen::Vector2d bends = solver.eigenvalues().cwiseMin(0);
  if (bends == solver.eigenvalues()) return {a[0], a[1], a[2]};  // all of it, to the bit
  const Eigen::Matrix2d part =
      solver.eigenvectors() * bends.asDiagonal() * solver.eigenvectors().transpose();
  return {part(0, 0), part(1, 1), 2 * part(0, 1)};
}

}  // namespace

Coefficients with_curvature_gain(const Coefficients& a, const Peak& peak, double gain) {
  const auto [u, v] = peak.light;
  const auto [q0, q1, q2] = downwards(a);
  const double more = gain - 1;
  Coefficients out = a;
  out[0] += more * q0;
  out[1] += more * q1;
  out[2] += more * q2;
  out[3] -= more * (2 * q0 * u + q2 * v);
  out[4] -= more * (2 * q1 * v + q2 * u);
  out[5] += more * (q0 * u * u + q1 * v * v + q2 * u * v);
  return out;
}

}  // namespace ptm::golden
