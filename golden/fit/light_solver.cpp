#include "golden/fit/light_solver.h"

#include <Eigen/SVD>
#include <stdexcept>

namespace ptm::golden {

Eigen::Matrix<double, 6, 1> light_basis(double u, double v) {
  Eigen::Matrix<double, 6, 1> b;
  b << u * u, v * v, u * v, u, v, 1.0;
  return b;
}

LightSolver solve_lights(std::span<const std::array<double, 3>> directions) {
  if (directions.empty()) throw std::invalid_argument("a fit needs at least one light");
  Eigen::Matrix<double, Eigen::Dynamic, 6> design(static_cast<Eigen::Index>(directions.size()), 6);
  Eigen::Index row = 0;
  for (const auto& d : directions) design.row(row++) = light_basis(d[0], d[1]).transpose();
  return solve_design(design);
}

LightSolver solve_design(const Eigen::Matrix<double, Eigen::Dynamic, 6>& design) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(design, Eigen::ComputeThinU | Eigen::ComputeThinV);
  LightSolver solver;
  solver.singular_values = svd.singularValues();
  Eigen::VectorXd reciprocal = Eigen::VectorXd::Zero(solver.singular_values.size());
  // The design's last column is 1, so the largest singular value is at least 1.
  const double largest = solver.singular_values[0];
  for (Eigen::Index k = 0; k < reciprocal.size(); ++k) {
    const double value = solver.singular_values[k];
    if (value < kRankTolerance * largest) break;
    reciprocal[k] = 1 / value;
    solver.condition = largest / value;
    ++solver.rank;
  }
  solver.subspace = svd.matrixV().leftCols(solver.rank);
  solver.leverage = svd.matrixU().leftCols(solver.rank).rowwise().squaredNorm();
  solver.design = design;
  solver.inverse = svd.matrixV() * reciprocal.asDiagonal() * svd.matrixU().transpose();
  return solver;
}

}  // namespace ptm::golden
