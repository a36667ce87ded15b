#include "golden/fit/light_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "golden/scene/relief.h"

namespace ptm::golden {
namespace {

using Directions = std::vector<std::array<double, 3>>;

Directions ring(int count, double z) {
  Directions lights;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count, r = std::sqrt(1 - z * z);
    lights.push_back({r * std::cos(angle), r * std::sin(angle), z});
  }
  return lights;
}

Eigen::MatrixXd design(const Directions& lights) {
  Eigen::MatrixXd a(static_cast<Eigen::Index>(lights.size()), 6);
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    const auto& d = lights[static_cast<std::size_t>(i)];
    a.row(i) = light_basis(d[0], d[1]).transpose();
  }
  return a;
}

/// The four conditions that make a matrix the pseudo-inverse, and no other.
void expect_pseudo_inverse(const Eigen::MatrixXd& p, const Eigen::MatrixXd& a) {
  const double small = 1e-10;
  EXPECT_LT((a * p * a - a).norm(), small);
  EXPECT_LT((p * a * p - p).norm(), small * p.norm());
  EXPECT_LT((a * p - (a * p).transpose()).norm(), small);
  EXPECT_LT((p * a - (p * a).transpose()).norm(), small);
}

TEST(LightSolver, IsThePseudoInverseForGoodAndForDegenerateLights) {
  Directions line, duplicates;
  for (int i = 0; i < 9; ++i) line.push_back({0.1 * i, 0, std::sqrt(1 - 0.01 * i * i)});
  for (int i = 0; i < 10; ++i) duplicates.push_back(i % 2 ? ring(5, 0.5)[1] : ring(5, 0.7)[3]);
  const struct {
    Directions lights;
    int rank;
  } cases[] = {
      {spread_lights(50), 6},
      {spread_lights(6), 6},
      {spread_lights(5), 5},
      {ring(12, 0.6), 5},  // u^2 + v^2 is the same everywhere
      {line, 3},           // u^2, u, 1
      {duplicates, 2},
      {{{0, 0, 1}}, 1},
  };
  for (const auto& [lights, rank] : cases) {
    const LightSolver solver = solve_lights(lights);
    EXPECT_EQ(solver.rank, rank) << lights.size() << " lights";
    expect_pseudo_inverse(solver.inverse, design(lights));
  }
}

TEST(LightSolver, RecoversAPolynomialFromItsSamples) {
  const Directions lights = spread_lights(30);
  const LightSolver solver = solve_lights(lights);
  Eigen::Matrix<double, 6, 1> truth;
  truth << -120.5, 33.25, 7, 90, -45, 200;
  EXPECT_LT((solver.inverse * (design(lights) * truth) - truth).norm(), 1e-9);
  EXPECT_EQ(solver.singular_values.size(), 6);
  EXPECT_GT(solver.condition, 1);
  EXPECT_LT(solver.condition, 20);
}

TEST(LightSolver, TreatsNearlyDegenerateLightsAsDegenerate) {
  Directions almost_ring = ring(12, 0.6);
  for (std::size_t i = 0; i < almost_ring.size(); ++i) {
    for (double& c : almost_ring[i]) c *= 1 + (i % 2 ? 1e-9 : -1e-9);
  }
  const LightSolver solver = solve_lights(almost_ring);
  EXPECT_EQ(solver.rank, 5);
  EXPECT_LT(solver.inverse.cwiseAbs().maxCoeff(), 10);
}

TEST(LightSolver, RefusesNoLights) { EXPECT_THROW((void)solve_lights({}), std::invalid_argument); }

}  // namespace
}  // namespace ptm::golden
