#include "golden/fit/light_coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "golden/fit/contradiction.h"
#include "golden/scene/relief.h"

namespace ptm::golden {
namespace {

using Lights = std::vector<std::array<double, 3>>;

/// `count` lights all round at one elevation, in degrees.
void add_ring(Lights& lights, int count, double elevation) {
  const double w = std::sin(elevation * std::numbers::pi / 180), r = std::sqrt(1 - w * w);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    lights.push_back({r * std::cos(angle), r * std::sin(angle), w});
  }
}

TEST(LightCoverage, OfAnEvenDomeLeavesNothingToExtrapolation) {
  const LightCoverage coverage = cover_hemisphere(solve_lights(spread_lights(40)));
  EXPECT_LT(coverage.extrapolated, 0.05) << coverage.directions;
}

TEST(LightCoverage, NamesTheSideThatHasNoLight) {
  Lights half;
  for (const double elevation : {20.0, 45.0, 70.0}) {
    Lights ring;
    add_ring(ring, 12, elevation);
    for (const auto& light : ring) {
      if (light[0] > 0.05) half.push_back(light);
    }
  }
  const LightCoverage coverage = cover_hemisphere(solve_lights(half));
  EXPECT_GT(coverage.extrapolated, kNarrowCoverage);
  EXPECT_NE(coverage.directions.find("from the left below"), std::string::npos);
  EXPECT_EQ(coverage.directions.find("from the right below"), std::string::npos)
      << coverage.directions;
}

TEST(LightCoverage, OfOneRingIsThatRing) {
  // All lights at one height determine nothing off it: u^2 + v^2 cannot be told from 1.
  Lights ring;
  add_ring(ring, 24, 45);
  const LightSolver solver = solve_lights(ring);
  EXPECT_EQ(solver.rank, 5);
  EXPECT_GT(cover_hemisphere(solver).extrapolated, 0.9);
  EXPECT_TRUE(std::isinf(prediction_variance(solver, 0.1, 0)));
  EXPECT_NEAR(prediction_variance(solver, std::sqrt(0.5), 0), solver.leverage[0], 1e-9);
}

TEST(LightCoverage, OfANarrowConeIsTheSameFromAllSides) {
  Lights cone{{0, 0, 1}};
  add_ring(cone, 8, 80);
  add_ring(cone, 8, 70);
  const LightCoverage coverage = cover_hemisphere(solve_lights(cone));
  EXPECT_GT(coverage.extrapolated, 0.7);
  EXPECT_TRUE(coverage.directions.starts_with("from all sides below ")) << coverage.directions;
}

TEST(LightCoverage, VarianceIsThatOfTheFitsPrediction) {
  // By definition: the prediction is b . P y, its variance |P^T b|^2 of one sample's.
  const LightSolver solver = solve_lights(spread_lights(9));
  for (const double u : {-0.8, 0.0, 0.3, 0.9}) {
    const double v = 0.4 * u - 0.1;
    EXPECT_NEAR(prediction_variance(solver, u, v),
                (solver.inverse.transpose() * light_basis(u, v)).squaredNorm(), 1e-9);
  }
}

/// Photographs of polynomials, with noise of a level and highlights of their own under each light.
ContradictionSample made_sample(std::size_t lights, std::size_t fitted) {
  ContradictionSample sample;
  sample.fitted = fitted;
  const auto directions = spread_lights(static_cast<int>(lights));
  auto& design = sample.designs.emplace_back(static_cast<Eigen::Index>(lights), 6);
  for (std::size_t i = 0; i < lights; ++i) {
    design.row(static_cast<Eigen::Index>(i)) =
        light_basis(directions[i][0], directions[i][1]).transpose();
  }
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 1);
  for (int t = 0; t < 400; ++t) {
    Eigen::Matrix<double, 6, 1> a;
    for (double& x : a) x = 20 * noise(random);
    a[5] += 120;
    Eigen::VectorXd& y = sample.levels.emplace_back(design * a);
    for (double& level : y) level += noise(random) + (noise(random) > 2 ? 8 : 0);
  }
  return sample;
}

void brighten(ContradictionSample& sample, Eigen::Index photograph) {
  for (Eigen::VectorXd& y : sample.levels) y[photograph] = 60 + 1.3 * y[photograph];
}

TEST(Contradictions, OfGoodPhotographsAreNone) {
  for (const std::size_t lights : {7U, 9U, 12U, 20U, 60U}) {
    const ContradictionSample sample = made_sample(lights, lights);
    const Contradictions found = find_contradictions(sample);
    EXPECT_EQ(std::count(found.contradicts.begin(), found.contradicts.end(), true), 0) << lights;
  }
}

TEST(Contradictions, AreFoundThoughTheySpoilAllResidualsAndHideEachOther) {
  for (const std::size_t lights : {12U, 20U, 60U}) {
    ContradictionSample sample = made_sample(lights, lights - 2);
    std::vector<bool> wanted(lights);
    for (const std::size_t bad : {std::size_t{3}, lights - 1}) {
      brighten(sample, static_cast<Eigen::Index>(bad));
      wanted[bad] = true;
      EXPECT_EQ(find_contradictions(sample).contradicts, wanted) << lights;
    }
    if (lights < 20) continue;
    for (Eigen::VectorXd& y : sample.levels) std::swap(y[5], y[11]);  // in each other's place
    wanted[5] = wanted[11] = true;
    EXPECT_EQ(find_contradictions(sample).contradicts, wanted) << lights;
  }
}

TEST(Contradictions, FiguresAreTheNoiseOfOneSample) {
  ContradictionSample sample = made_sample(40, 30);
  std::mt19937 random(8);
  std::normal_distribution<double> noise(0, 5);
  for (Eigen::VectorXd& y : sample.levels) {
    y = Eigen::VectorXd::Constant(40, 100);
    for (double& level : y) level += noise(random);
  }
  // 400 texels: an RMS is off by 1 / sqrt(800) of itself, five of which are 18 %.
  for (const auto& figure : find_contradictions(sample).figures) EXPECT_NEAR(*figure, 5, 0.9);
}

}  // namespace
}  // namespace ptm::golden
