#include "golden/bump/normal_fit.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include "golden/fit/light_solver.h"

namespace ptm::golden {
namespace {

constexpr int kNodes = 8;  ///< of Gauss-Legendre: exact for polynomials of degree 15

struct Rule {
  std::array<double, kNodes> node{}, weight{};  ///< on [-1, 1]
};

/// Gauss-Legendre nodes by Newton's method on the Legendre polynomial.
Rule gauss_legendre() {
  Rule rule;
  for (int i = 0; i < kNodes; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (kNodes + 0.5)), slope = 1;
    for (int step = 0; step < 20; ++step) {
      double p = 1, before = 0;
      for (int n = 1; n <= kNodes; ++n) {
        const double next = ((2 * n - 1) * x * p - (n - 1) * before) / n;
        before = p;
        p = next;
      }
      slope = kNodes * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    const auto k = static_cast<std::size_t>(i);
    rule.node[k] = x;
    rule.weight[k] = 2 / ((1 - x * x) * slope * slope);
  }
  return rule;
}

/// Integrals of f(lu, lv, root) over the disc, or by solid angle over the hemisphere. With w =
/// sqrt(1 - r^2), r dr = -w dw: the root is a polynomial in w, and the rule exact; angles are
/// equally spaced, exact for low harmonics.
template <class Integrand>
void integrate_disc(bool solid_angle, Integrand add) {
  constexpr int angles = 16;
  const Rule rule = gauss_legendre();
  for (std::size_t i = 0; i < kNodes; ++i) {
    const double w = (rule.node[i] + 1) / 2, r = std::sqrt(1 - w * w);
    for (int k = 0; k < angles; ++k) {
      const double angle = 2 * std::numbers::pi * k / angles;
      const double area = rule.weight[i] / 2 * 2 * std::numbers::pi / angles;
      const double weight = solid_angle ? area : area * w;
      add(r * std::cos(angle), r * std::sin(angle), w, weight);
    }
  }
}

template <class Integrand>
void integrate_square(Integrand add) {
  const Rule rule = gauss_legendre();
  for (std::size_t i = 0; i < kNodes; ++i) {
    for (std::size_t j = 0; j < kNodes; ++j) {
      add(rule.node[i], rule.node[j], rule.weight[i] * rule.weight[j]);
    }
  }
}

}  // namespace

Eigen::Matrix<double, 6, 3> normal_fit(BumpDomain domain) {
  Eigen::Matrix<double, 6, 6> moments = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 3> products = Eigen::Matrix<double, 6, 3>::Zero();
  const auto add_moments = [&](double u, double v, double weight) {
    const auto b = light_basis(u, v);
    moments += weight * b * b.transpose();
    products.col(0) += weight * u * b;
    products.col(1) += weight * v * b;
  };
  if (domain == BumpDomain::square) integrate_square(add_moments);
  // The root lives on the disc alone, whatever the domain.
  const bool solid_angle = domain == BumpDomain::hemisphere;
  integrate_disc(solid_angle, [&](double u, double v, double root, double weight) {
    if (domain != BumpDomain::square) add_moments(u, v, weight);
    products.col(2) += weight * root * light_basis(u, v);
  });
  return moments.llt().solve(products);
}

}  // namespace ptm::golden
