#include "golden/fit/reweigh.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace ptm::golden {
namespace {

constexpr double kCauchy = 2.3849;         ///< 95 % efficiency on normal residuals
constexpr double kMedianToSigma = 1.4826;  ///< of normal residuals
constexpr double kSmallestSigma = 0.5;     ///< levels: photographs are rounded to one

}  // namespace

Reweigher::Reweigher(const LightSolver& solver)
    : solver_(solver),
      design_(solver.design),
      reduced_(solver.design * solver.subspace),
      residuals_(solver.design.rows()),
      weights_(Eigen::VectorXd::Ones(solver.design.rows())),
      sorted_(solver.design.rows()) {}

void Reweigher::take_design(const Eigen::Matrix<double, Eigen::Dynamic, 6>& design) {
  design_ = design;
  reduced_ = design_ * solver_.subspace;
}

void Reweigher::weigh() {
  sorted_ = residuals_.cwiseAbs();
  double* middle = sorted_.data() + sorted_.size() / 2;
  std::nth_element(sorted_.data(), middle, sorted_.data() + sorted_.size());
  const double unit = kCauchy * std::max(kMedianToSigma * *middle, kSmallestSigma);
  weights_ = (1 + (residuals_ / unit).array().square()).inverse();
}

void Reweigher::improve(std::span<const double> samples, std::span<double, 6> coef, int passes) {
  const Eigen::Map<const Eigen::VectorXd> y(samples.data(),
                                            static_cast<Eigen::Index>(samples.size()));
  Eigen::Map<Eigen::Matrix<double, 6, 1>> a(coef.data());
  for (int pass = 0; pass < passes; ++pass) {
    residuals_ = y - design_ * a;
    weigh();
    const Eigen::MatrixXd weighted = weights_.asDiagonal() * reduced_;
    const Eigen::MatrixXd normal = reduced_.transpose() * weighted;
    a = solver_.subspace * normal.ldlt().solve(weighted.transpose() * y);
  }
}

}  // namespace ptm::golden
