#include "model/reference/light_code.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "model/reference/fragment.h"

namespace ptm::reference {
namespace {

TEST(LightCode, RoundsToTheNearestStep) {
  EXPECT_EQ(light_code(kBase, 0.5), 128);
  EXPECT_EQ(light_code(kBase, 0.5 / 256), 1) << "a tie goes up";
  EXPECT_EQ(light_code(kBase, -0.5 / 256), 0) << "on both sides";
  EXPECT_EQ(light_code(kBase, -1.0), -256);
}

TEST(LightCode, LimitsEqualityWithTheRangeSilently) {
  EXPECT_EQ(light_code(kPaper8, -1.0), -127);
  EXPECT_EQ(light_code(kPaper8, 1.0), 127);
  EXPECT_EQ(light_code(kBase, 2.0), 511);
}

TEST(LightCode, DoesNotExistBeyondTheRangeOrForNonNumbers) {
  EXPECT_FALSE(light_code(kPaper8, std::nextafter(1.0, 2.0)));
  EXPECT_FALSE(light_code(kBase, -2.0001));
  EXPECT_FALSE(light_code(kBase, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(light_code(kBase, std::numeric_limits<double>::infinity()));
}

TEST(Fragment, HoldsCoordinatesInTwentyFractionBits) {
  const auto fragment = quantize_fragment(kBase, 3, 4, {0.25, 0.75, 0.5, -0.5});
  ASSERT_TRUE(fragment);
  EXPECT_EQ(fragment->u, 1 << 18);
  EXPECT_EQ(fragment->v, 3 << 18);
  EXPECT_EQ(fragment->lu, 128);
  EXPECT_FALSE(quantize_fragment(kBase, 0, 0, {256.0, 0, 0, 0}));
  EXPECT_FALSE(quantize_fragment(kPaper8, 0, 0, {0, 0, 0, 1.5}));
}

TEST(NearestIndex, FindsEveryTexelOfAlignedMapsOfAnySize) {
  for (const int size : {1, 2, 3, 395, 402, 512, 1023, 4095, 4096}) {
    for (int x = 0; x < size; ++x) {
      const auto fragment = quantize_fragment(kBase, x, 0, {(x + 0.5) / size, 0, 0, 0});
      ASSERT_EQ(nearest_index(fragment->u, size), x) << "of " << size;
    }
  }
}

}  // namespace
}  // namespace ptm::reference
