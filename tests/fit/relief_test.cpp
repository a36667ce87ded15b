#include "golden/scene/relief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace ptm::golden {
namespace {

std::array<double, 3> light(double azimuth_deg, double elevation_deg) {
  const double a = azimuth_deg * std::numbers::pi / 180, e = elevation_deg * std::numbers::pi / 180;
  return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

double mean(const Image8& picture) {
  return std::accumulate(picture.samples.begin(), picture.samples.end(), 0.0) /
         static_cast<double>(picture.samples.size());
}

/// Share of pixels that get next to no light although, by the surface alone, most would.
double dark_share(const Image8& picture) {
  const auto dark = std::count_if(picture.samples.begin(), picture.samples.end(),
                                  [](std::uint8_t level) { return level < 8; });
  return static_cast<double>(dark) / static_cast<double>(picture.samples.size());
}

TEST(Relief, GivesTheSamePhotographForTheSameSeedAndAnotherForAnother) {
  const auto from = light(30, 40);
  const Image8 first = Relief({.size = 64, .seed = 5}).photograph(from);
  EXPECT_EQ(Relief({.size = 64, .seed = 5}).photograph(from).samples, first.samples);
  EXPECT_NE(Relief({.size = 64, .seed = 6}).photograph(from).samples, first.samples);
}

TEST(Relief, LightsSlopesThatFaceTheLamp) {
  // Over the whole slab: pixels whose surface falls to the left are brighter with the lamp there.
  const Relief relief({.size = 96, .seed = 1});
  const Image8 left = relief.photograph(light(180, 45)), right = relief.photograph(light(0, 45));
  const Image8 up = relief.photograph(light(90, 45)), down = relief.photograph(light(270, 45));
  double horizontal = 0, vertical = 0;
  for (int y = 1; y < 95; ++y) {
    for (int x = 1; x < 95; ++x) {
      const double dx = relief.height().at(x + 1, y) - relief.height().at(x - 1, y);
      const double dy = relief.height().at(x, y - 1) - relief.height().at(x, y + 1);  // upwards
      horizontal += dx * (left.at(x, y) - right.at(x, y));
      vertical += dy * (down.at(x, y) - up.at(x, y));
    }
  }
  EXPECT_GT(horizontal, 0);
  EXPECT_GT(vertical, 0);
}

TEST(Relief, CastsLongerShadowsFromLowerLamps) {
  const Relief relief({.size = 128, .seed = 1});
  const double high = dark_share(relief.photograph(light(200, 80)));
  const double middle = dark_share(relief.photograph(light(200, 40)));
  const double low = dark_share(relief.photograph(light(200, 15)));
  EXPECT_LT(high, middle);
  EXPECT_LT(middle, low);
  EXPECT_GT(low, 0.15);
}

TEST(Relief, ShadowsFallAwayFromTheLamp) {
  // Beside the raised frame, inside it: dark where the frame stands between lamp and floor.
  const Relief relief({.size = 128, .seed = 1});
  const auto column = [](const Image8& picture, int x) {
    double sum = 0;
    for (int y = 50; y < 78; ++y) sum += picture.at(x, y, 0);
    return sum;
  };
  const auto row = [](const Image8& picture, int y) {
    double sum = 0;
    for (int x = 50; x < 78; ++x) sum += picture.at(x, y, 0);
    return sum;
  };
  const Image8 left = relief.photograph(light(180, 15)), right = relief.photograph(light(0, 15));
  EXPECT_LT(column(left, 8), 0.5 * column(right, 8));
  EXPECT_LT(column(right, 119), 0.5 * column(left, 119));
  const Image8 above = relief.photograph(light(90, 15)), below = relief.photograph(light(270, 15));
  EXPECT_LT(row(above, 8), 0.5 * row(below, 8));
  EXPECT_LT(row(below, 119), 0.5 * row(above, 119));
}

TEST(Relief, IsExposedSoThatLittleIsCutOff) {
  const Relief relief({.size = 128, .seed = 1});
  for (const auto& from : spread_lights(12)) {
    const Image8 picture = relief.photograph(from);
    const auto white = std::count(picture.samples.begin(), picture.samples.end(), 255);
    EXPECT_LT(static_cast<double>(white), 0.02 * static_cast<double>(picture.samples.size()));
  }
  EXPECT_GT(mean(relief.photograph(light(0, 85))), 90);
}

TEST(Relief, RefusesSizesOutOfRange) {
  for (const int size : {-1, 0, 15, 4097}) {
    EXPECT_THROW((void)Relief({.size = size, .seed = 1}), std::invalid_argument);
  }
  EXPECT_NO_THROW((void)Relief({.size = 16, .seed = 1}));
}

TEST(SpreadLights, AreUnitVectorsAboveTenDegreesAndCoverTheHemisphereEvenly) {
  const auto lights = spread_lights(50);
  ASSERT_EQ(lights.size(), 50U);
  double mean_z = 0, mean_x = 0, mean_y = 0, nearest = 2;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const auto& l = lights[i];
    EXPECT_NEAR(std::hypot(l[0], l[1], l[2]), 1, 1e-12);
    EXPECT_GE(l[2], std::sin(10 * std::numbers::pi / 180));
    mean_x += l[0] / 50;
    mean_y += l[1] / 50;
    mean_z += l[2] / 50;
    for (std::size_t j = 0; j < i; ++j) {
      nearest = std::min(nearest,
                         std::hypot(l[0] - lights[j][0], l[1] - lights[j][1], l[2] - lights[j][2]));
    }
  }
  // Even by solid angle between heights sin 10 degrees and 1: the mean height is half-way.
  EXPECT_NEAR(mean_z, (1 + std::sin(10 * std::numbers::pi / 180)) / 2, 1e-9);
  EXPECT_NEAR(mean_x, 0, 0.05);
  EXPECT_NEAR(mean_y, 0, 0.05);
  EXPECT_GT(nearest, 0.15);  // 50 discs on 5.2 steradian: 0.36 apart in the best of arrangements
}

TEST(SpreadLights, RefusesNone) { EXPECT_THROW((void)spread_lights(0), std::invalid_argument); }

}  // namespace
}  // namespace ptm::golden
