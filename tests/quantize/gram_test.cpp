#include "model/quantize/gram.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace ptm::quantize {
namespace {

/// Midpoint rule over height and azimuth: on a sphere equal steps of z are equal solid angles.
std::vector<std::array<double, 2>> even_hemisphere(int rings, int spokes) {
  std::vector<std::array<double, 2>> lights;
  for (int r = 0; r < rings; ++r) {
    const double z = (r + 0.5) / rings, radius = std::sqrt(1 - z * z);
    for (int s = 0; s < spokes; ++s) {
      const double angle = 2 * std::numbers::pi * (s + 0.5) / spokes;
      lights.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
  }
  return lights;
}

TEST(HemisphereGram, EqualsTheMeanOverLightsEvenBySolidAngle) {
  // The midpoint rule errs by at most 1/24 of the second derivative over rings^2; the integrands
  // are polynomials in z of degree 4 with second derivatives under 12.
  const Gram sampled = gram_of_lights(even_hemisphere(400, 32));
  EXPECT_LT((sampled - hemisphere_gram()).cwiseAbs().maxCoeff(), 0.5 / (400.0 * 400.0));
}

TEST(GramFactor, IsUpperTriangularAndMultipliesBackToTheMatrix) {
  const Gram r = gram_factor(hemisphere_gram());
  EXPECT_LT((r.transpose() * r - hemisphere_gram()).cwiseAbs().maxCoeff(), 1e-14);
  for (int i = 1; i < 6; ++i) {
    for (int j = 0; j < i; ++j) EXPECT_EQ(r(i, j), 0.0);
  }
}

TEST(GramFactor, SettlesWhatTooFewLightsLeaveOpen) {
  const std::vector<std::array<double, 2>> line{{0, 0}, {0.2, 0}, {0.5, 0}, {0.9, 0}};
  const std::vector<std::array<double, 2>> one{{0.3, 0.4}};
  for (const auto& lights : {line, one}) {
    const Gram g = gram_of_lights(lights);
    const Gram r = gram_factor(g);
    ASSERT_TRUE(r.allFinite());
    for (int i = 0; i < 6; ++i) EXPECT_GT(r(i, i), 1e-3);
    EXPECT_LT((r.transpose() * r - g).norm(), 2e-3 * g.trace());
  }
}

TEST(GramFactor, RefusesMatricesThatAreNoSecondMoments) {
  Gram skew = hemisphere_gram();
  skew(0, 1) += 0.1;
  Gram negative = hemisphere_gram();
  negative(3, 3) = -1;
  Gram nan = hemisphere_gram();
  nan(2, 2) = NAN;
  for (const Gram& bad : {skew, negative, nan, Gram(Gram::Zero())}) {
    EXPECT_THROW((void)gram_factor(bad), std::invalid_argument);
  }
}

TEST(GramOfLights, RefusesNoLightsAndLightsThatAreNotFinite) {
  EXPECT_THROW((void)gram_of_lights({}), std::invalid_argument);
  const std::vector<std::array<double, 2>> nan{{0.1, NAN}};
  EXPECT_THROW((void)gram_of_lights(nan), std::invalid_argument);
}

}  // namespace
}  // namespace ptm::quantize
