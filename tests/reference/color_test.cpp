#include "model/reference/color.h"

#include <gtest/gtest.h>

#include "tests/reference/exact_rational.h"

namespace ptm::reference {
namespace {

constexpr Value kLargestProduct = Value{4096} * 255;  ///< lum_bits = 12, a rounded-up luminance

TEST(Divide255, IsTheExactQuotientForEveryProductThatCanOccur) {
  for (Value p = 0; p <= kLargestProduct; ++p) {
    const Value nearest = std::min<Value>(255, (2 * p + 255) / 510);
    const Value truncated = std::min<Value>(255, p / 255);
    ASSERT_EQ(std::min<Value>(255, divide_255(Rounding::nearest, p)), nearest) << p;
    ASSERT_EQ(std::min<Value>(255, divide_255(Rounding::truncate, p)), truncated) << p;
  }
}

TEST(ColorScale, FlagsExactlyTheChannelsThatWereLimited) {
  EXPECT_EQ(color_scale(kBase, Three<Value>{255 * 255, 0, 255}).saturated, 0);
  EXPECT_EQ(color_scale(kBase, Three<Value>{255 * 255 + 127, 0, 255}).saturated, 0);
  const auto limited = color_scale(kBase, Three<Value>{255 * 255 + 128, 0, 255});
  EXPECT_EQ(limited.saturated, 1);
  EXPECT_EQ(limited.out, (Three<Value>{255, 0, 1}));
}

TEST(ColorScale, DropsLuminanceAndFilterFractionTogether) {
  EvalConfig config = kWide;  // lum_frac 4
  config.filter_frac = 2;
  // 100.5 (4 fraction bits) times 128.25 (2) is 12889.125; over 255 it is 50.55.
  const auto color = color_scale(config, color_products(Value{1608}, Three<Value>{513, 0, 0}));
  EXPECT_EQ(color.out[0], 51);
}

TEST(ColorDirect, RoundsAndLimitsEachChannelOfAnRgbMap) {
  const auto color = color_direct(kWide, Three<Value>{16 * 254 + 8, 16 * 255 + 8, 7});
  EXPECT_EQ(color.out, (Three<Value>{255, 255, 0}));
  EXPECT_EQ(color.saturated, 1) << "255.5 rounds to 256, which is limited";
}

}  // namespace
}  // namespace ptm::reference
