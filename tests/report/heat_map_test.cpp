#include "testbench/compare/heat_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace ptm::testbench {
namespace {

/// Lightness L* of CIELAB from sRGB (IEC 61966-2-1).
double lightness(const Rgb8& color) {
  const double weights[3] = {0.2126, 0.7152, 0.0722};
  double y = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double v = color[c] / 255.0;
    y += weights[c] * (v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
  }
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(HeatColor, GrowsLighterWithEveryStepAndSpansNearlyBlackToNearlyWhite) {
  EXPECT_LT(lightness(heat_color(0)), 3);
  EXPECT_GT(lightness(heat_color(1)), 95);
  for (int i = 1; i <= 100; ++i) {
    const double step = lightness(heat_color(i / 100.0)) - lightness(heat_color((i - 1) / 100.0));
    EXPECT_GT(step, 0.2) << i;
    EXPECT_LT(step, 2) << i;
  }
}

TEST(HeatColor, LimitsWhatLiesOutside) {
  EXPECT_EQ(heat_color(-3), heat_color(0));
  EXPECT_EQ(heat_color(7), heat_color(1));
}

Rgb8 color_at(const golden::Image8& map, int x, int y) {
  return {map.at(x, y, 0), map.at(x, y, 1), map.at(x, y, 2)};
}

TEST(HeatMap, ShowsTheLargestChannelErrorAgainstFullScale) {
  golden::ImageReal a(2, 1, 3);
  golden::ImageReal b = a;
  b.at(1, 0, 0) = 0.5;
  b.at(1, 0, 2) = 1.5;
  a.at(0, 0, 1) = 3;
  const golden::Image8 map = heat_map(a, b, 3);
  EXPECT_EQ(color_at(map, 0, 0), heat_color(1));
  EXPECT_EQ(color_at(map, 1, 0), heat_color(0.5));
}

TEST(HeatMap, OfEqualPicturesIsTheLowestColorEverywhere) {
  const golden::ImageReal a(3, 2, 3);
  const golden::Image8 map = heat_map(a, a, 0);
  EXPECT_EQ(color_at(map, 2, 1), heat_color(0));
}

TEST(HeatMap, KeepsASingleWrongPixelWhenItIsReduced) {
  const golden::ImageReal a(7, 5, 3);
  // At the block's corners, inside it, and in the block cut off by the lower right edge.
  const int rows[4][4] = {{0, 0, 0, 0}, {3, 3, 0, 0}, {5, 2, 1, 0}, {6, 4, 1, 1}};
  for (const auto& [x, y, column, row] : rows) {
    golden::ImageReal b = a;
    b.at(x, y, 1) = 1;
    const golden::Image8 map = heat_map(a, b, 1, 4);
    ASSERT_EQ(map.width, 2);
    ASSERT_EQ(map.height, 2);
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(color_at(map, i, j), heat_color(i == column && j == row ? 1 : 0))
            << x << ' ' << y;
      }
    }
  }
}

TEST(HeatMap, RefusesPicturesOfDifferentSizesAndAnEmptyBlock) {
  EXPECT_THROW((void)heat_map({2, 2, 3}, {2, 3, 3}, 1), std::invalid_argument);
  EXPECT_THROW((void)heat_map({2, 2, 3}, {2, 2, 3}, 1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace ptm::testbench
