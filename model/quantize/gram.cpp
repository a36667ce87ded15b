#include "model/quantize/gram.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <stdexcept>

namespace ptm::quantize {

Eigen::Matrix<double, 6, 1> basis(double lu, double lv) {
  Eigen::Matrix<double, 6, 1> b;
  b << lu * lu, lv * lv, lu * lv, lu, lv, 1.0;
  return b;
}

Gram hemisphere_gram() {
  Gram g = Gram::Zero();
  g(0, 0) = g(1, 1) = 1.0 / 5;
  g(0, 1) = g(1, 0) = g(2, 2) = 1.0 / 15;
  g(0, 5) = g(5, 0) = g(1, 5) = g(5, 1) = g(3, 3) = g(4, 4) = 1.0 / 3;
  g(5, 5) = 1.0;
  return g;
}

Gram gram_of_lights(std::span<const std::array<double, 2>> lights) {
  if (lights.empty()) throw std::invalid_argument("a Gram matrix of no lights");
  Gram g = Gram::Zero();
  for (const auto& [lu, lv] : lights) {
    if (!std::isfinite(lu) || !std::isfinite(lv)) {
      throw std::invalid_argument("a Gram matrix of a light that is not finite");
    }
    const auto b = basis(lu, lv);
    g += b * b.transpose();
  }
  return g / static_cast<double>(lights.size());
}

Gram gram_factor(const Gram& gram) {
  if (!gram.allFinite() || !gram.isApprox(gram.transpose(), 1e-12)) {
    throw std::invalid_argument("a Gram matrix must be finite and symmetric");
  }
  const Eigen::SelfAdjointEigenSolver<Gram> eigen(gram, Eigen::EigenvaluesOnly);
  const double low = eigen.eigenvalues().minCoeff(), high = eigen.eigenvalues().maxCoeff();
  if (high <= 0 || low < -1e-9 * high) {
    throw std::invalid_argument("a Gram matrix must not have a negative eigenvalue, nor be zero");
  }
  Gram regular = gram;
  if (low < 1e-9 * high) {
    const Gram other = hemisphere_gram();
    regular += 1e-3 * (gram.trace() / other.trace()) * other;
  }
  return regular.llt().matrixU();
}

}  // namespace ptm::quantize
