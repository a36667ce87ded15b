#pragma once
#include <span>

#include "golden/fit/light_solver.h"

namespace ptm::golden {

/// One texel's polynomial fitted again `passes` times, with Cauchy's weights from the residuals of
/// the fit before (fit_tile.h). Where the lights leave coefficients open, the solution stays in the
/// subspace that they determine, as the minimum-norm one does.
class Reweigher {
 public:
  explicit Reweigher(const LightSolver& solver);

  /// Takes other rows of the basis: those of a texel's own lights.
  void take_design(const Eigen::Matrix<double, Eigen::Dynamic, 6>& design);
  /// `coef` holds the plain fit of `samples`, one a light, in levels; both are [6] and [light].
  /// Afterwards weights() are those of the last pass.
  void improve(std::span<const double> samples, std::span<double, 6> coef, int passes);
  [[nodiscard]] const Eigen::VectorXd& weights() const { return weights_; }

 private:
  void weigh();

  const LightSolver& solver_;
  Eigen::MatrixXd design_;
  Eigen::MatrixXd reduced_;  ///< design * subspace
  Eigen::VectorXd residuals_, weights_, sorted_;
};

}  // namespace ptm::golden
