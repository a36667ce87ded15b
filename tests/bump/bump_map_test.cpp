#include "golden/bump/bump_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <stdexcept>

#include "golden/files/input_error.h"
#include "golden/scene/relief.h"

namespace ptm::golden {
namespace {

TEST(NormalsFromHeights, LeanAwayFromTheSlope) {
  ImageReal ramp(5, 4, 1);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) ramp.at(x, y) = 255 * (0.5 * x + 0.25 * y);
  }
  const NormalField field = normals_from_heights(ramp, 2);
  ASSERT_EQ(field.normals.size(), 20U);
  const double length = std::sqrt(1 + 1 + 0.25);
  for (const auto& n : field.normals) {      // edges included: one-sided differences
    EXPECT_NEAR(n[0], -1 / length, 1e-12);   // rises to the right: leans left
    EXPECT_NEAR(n[1], 0.5 / length, 1e-12);  // rises downwards: leans up
    EXPECT_NEAR(n[2], 1 / length, 1e-12);
  }
  const NormalField flat = normals_from_heights(ramp, 0);
  EXPECT_EQ(flat.normals[7], (std::array<double, 3>{0, 0, 1}));
  EXPECT_THROW((void)normals_from_heights(ramp, NAN), std::invalid_argument);
  EXPECT_THROW((void)normals_from_heights(ImageReal{}, 1), std::invalid_argument);
}

TEST(NormalsFromColors, AreTheMapsAndBadPixelsAreNamed) {
  ImageReal map(2, 1, 3);
  const double s = std::sqrt(0.5);
  map.samples = {127.5 * (1 + s), 127.5, 127.5 * (1 + s), 127.5, 255, 128};
  const NormalField field = normals_from_colors(map, 1, "n.png");
  EXPECT_NEAR(field.normals[0][0], s, 1e-12);
  EXPECT_NEAR(field.normals[0][2], s, 1e-12);
  EXPECT_GT(field.normals[1][1], 0.999);
  const NormalField steep = normals_from_colors(map, 2, "n.png");
  EXPECT_NEAR(steep.normals[0][0] / steep.normals[0][2], 2, 1e-12);
  map.samples[5] = 100;
  try {
    (void)normals_from_colors(map, 1, "n.png");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("n.png: pixel (1, 0)"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW((void)normals_from_colors(ImageReal(2, 2, 1), 1, "n.png"), InputError);
}

TEST(MeasureBump, IsZeroForAPolynomialThatIsTheDotProductAndTheKnownValueForAFlatSurface) {
  // A normal on the horizon has no root to approximate: L = Nu lu exactly, 0 where it is negative.
  const NormalField edge{.width = 1, .height = 1, .normals = {{1, 0, 0}}};
  EXPECT_NEAR(measure_bump(edge, {0, 0, 0, 255, 0, 0}).max, 0, 1e-9);
  // Flat: (p + q r^2 - w) over w in [0, 1] evenly.
  const NormalField flat{.width = 1, .height = 1, .normals = {{0, 0, 1}}};
  for (const auto& [domain, square] :
       {std::pair{BumpDomain::hemisphere, 1.0 / 192}, {BumpDomain::disc, 0.008}}) {
    const BumpError error = measure_bump(flat, bump_coefficients(flat, NormalTable(domain)), 20000);
    EXPECT_NEAR(error.rmse, 255 * std::sqrt(square), 0.01);
  }
}

TEST(MeasureBump, OfAReliefIsPrintedForEveryDomainAndLeastForTheDefault) {
  const Relief relief({.size = 96});
  ImageReal heights = relief.height();
  for (double& h : heights.samples) h *= 255;  // half widths: 48 pixels
  const NormalField field = normals_from_heights(heights, 48);
  BumpError best;
  for (const auto& [name, domain] : {std::pair{"hemisphere", BumpDomain::hemisphere},
                                     {"disc", BumpDomain::disc},
                                     {"square", BumpDomain::square}}) {
    const BumpError error = measure_bump(field, bump_coefficients(field, NormalTable(domain)));
    std::cout << name << ": " << error.rmse << " levels RMS over the hemisphere, max " << error.max
              << ", by elevation";
    for (const double band : error.by_elevation) std::cout << ' ' << band;
    std::cout << '\n';
    if (domain == BumpDomain::hemisphere) {
      best = error;
    } else {
      EXPECT_LT(best.rmse, 0.9 * error.rmse) << name;
    }
  }
  EXPECT_LT(best.rmse, 20);
}

}  // namespace
}  // namespace ptm::golden
