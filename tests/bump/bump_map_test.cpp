#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <stdexcept>

#include "golden/bump/normal_map.h"
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

TEST(NormalMap, AreTheMapsAndBadPixelsAreNamed) {
  ImageReal map(2, 1, 3);
  const double s = std::sqrt(0.5);
  map.samples = {127.5 * (1 + s), 127.5, 127.5 * (1 + s), 127.5, 255, 128};
  const NormalField field = read_normal_map(map, {}, "n.png");
  EXPECT_NEAR(field.normals[0][0], s, 1e-12);
  EXPECT_NEAR(field.normals[0][2], s, 1e-12);
  EXPECT_GT(field.normals[1][1], 0.999);
  const NormalField steep = read_normal_map(map, {.strength = 2}, "n.png");
  EXPECT_NEAR(steep.normals[0][0] / steep.normals[0][2], 2, 1e-12);
  map.samples[5] = 100;
  try {
    (void)read_normal_map(map, {}, "n.png");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("n.png: pixel (1, 0)"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW((void)read_normal_map(ImageReal(2, 2, 1), {}, "n.png"), InputError);
}

/// A normal map of bumps and dents of 64 x 48 texels, rounded to eight bits.
ImageReal bumpy_normals(bool green_down) {
  ImageReal heights(64, 48, 1);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      heights.at(x, y) = 127.5 + 60 * std::sin(x * 0.31 + 0.2 * y) * std::cos(y * 0.23) +
                         40 * std::sin(0.11 * x - 0.37 * y);
    }
  }
  const NormalField field = normals_from_heights(heights, 16);
  ImageReal map(64, 48, 3);
  for (std::size_t t = 0; t < field.normals.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double part = field.normals[t][c] * (c == 1 && green_down ? -1 : 1);
      map.samples[t * 3 + c] = std::round(127.5 * (1 + part));
    }
  }
  return map;
}

TEST(NormalMap, TakesMaskedTexelsAndTheirBlurredEdgeAsFlat) {
  for (const double level : {0.0, 9.0, 128.0, 127.0, 255.0}) {
    ImageReal map = bumpy_normals(false);
    const auto set = [&](int x, int y, std::array<double, 3> rgb) {
      for (int c = 0; c < 3; ++c) map.at(x, y, c) = rgb[static_cast<std::size_t>(c)];
    };
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 5; ++x) set(x, y, {level, level, level});
      if (level < 100) set(5, y, {60, 70, 110});  // half black, half a normal
    }
    const NormalField field = read_normal_map(map, {}, "n.png");
    const std::size_t masked = level < 100 ? 288 : 240;
    ASSERT_EQ(field.notes.size(), 1U) << level;
    EXPECT_EQ(field.notes[0], std::to_string(masked) +
                                  " of 3072 texels are background without a normal, taken as flat");
    EXPECT_EQ(field.normals[3], (std::array<double, 3>{0, 0, 1})) << level;
    EXPECT_NE(field.normals[20], (std::array<double, 3>{0, 0, 1})) << level;
    // The same colour amidst normals is no edge of a background.
    set(30, 20, {60, 70, 110});
    EXPECT_THROW((void)read_normal_map(map, {}, "n.png"), InputError);
  }
  EXPECT_THROW((void)read_normal_map(ImageReal(4, 4, 3), {}, "black.png"), InputError);
}

TEST(NormalMap, SaysWhenGreenRunsTheOtherWayAndReadsItEitherWay) {
  const ImageReal up = bumpy_normals(false), down = bumpy_normals(true);
  const NormalField right = read_normal_map(up, {}, "n.png");
  EXPECT_TRUE(right.notes.empty());
  const NormalField turned = read_normal_map(down, {.green_down = true}, "n.png");
  EXPECT_TRUE(turned.notes.empty());
  const double rounding = 2.0 / 255;  // of the vectors; a level of green is rounded up or down
  for (std::size_t t = 0; t < right.normals.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_NEAR(turned.normals[t][c], right.normals[t][c], rounding);
    }
  }
  ASSERT_EQ(read_normal_map(down, {}, "n.png").notes.size(), 1U);
  EXPECT_NE(read_normal_map(down, {}, "n.png").notes[0].find("--green-down"), std::string::npos);
  EXPECT_EQ(read_normal_map(up, {.green_down = true}, "n.png").notes.size(), 1U);
}

TEST(NormalMap, SaysNothingOfGreenWhereTheNormalsDoNotTell) {
  ImageReal flat(32, 32, 3), ramp(32, 32, 3), noise(32, 32, 3);
  unsigned random = 1;
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      const double wave = 127.5 + 40 * std::sin(0.4 * y);
      for (int c = 0; c < 3; ++c) {
        random = random * 1664525U + 1013904223U;
        flat.at(x, y, c) = c == 2 ? 255 : 127 + static_cast<int>(random >> 31);
        ramp.at(x, y, c) = c == 2 ? 240 : c == 1 ? wave : 128;
        noise.at(x, y, c) = c == 2 ? 200 : 100 + static_cast<double>(random >> 26);
      }
    }
  }
  for (const ImageReal* map : {&flat, &ramp, &noise}) {
    for (const bool down : {false, true}) {
      EXPECT_TRUE(read_normal_map(*map, {.green_down = down}, "n.png").notes.empty());
    }
  }
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
