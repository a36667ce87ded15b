#include "model/reference/rounding.h"

#include <gtest/gtest.h>

#include "model/reference/lerp.h"
#include "tests/reference/exact_rational.h"

namespace ptm::reference {
namespace {

TEST(Narrow, EqualsFloorDivisionForEveryAmountAndBoundary) {
  for (int k = 0; k <= 40; ++k) {
    for (int power = 0; power <= 50; ++power) {
      for (Value near = -2; near <= 2; ++near) {
        for (const Value sign : {-1, 1}) {
          const Value x = sign * ((Value{1} << power) + near);
          for (const Rounding rounding : {Rounding::nearest, Rounding::truncate}) {
            const auto expected = tests::round_scaled(x, k, rounding == Rounding::nearest);
            ASSERT_EQ(narrow(rounding, x, Value{k}), static_cast<Value>(expected))
                << x << " by " << k;
          }
        }
      }
    }
  }
}

TEST(Narrow, OfATieGoesTowardPlusInfinityOnBothSides) {
  for (Value n = -1000; n <= 1000; ++n) {
    EXPECT_EQ(narrow(Rounding::nearest, 2 * n + 1, Value{1}), n + 1);
  }
}

TEST(NarrowConstant, OfANegativeAmountIsExact) {
  EXPECT_EQ(narrow_constant(Rounding::nearest, Value{-5}, -3), -40);
  EXPECT_EQ(narrow_constant(Rounding::truncate, Value{-5}, 0), -5);
}

TEST(Sat, ClampsToBothEndsOfTheRange) {
  for (int bits = 2; bits <= 20; ++bits) {
    const Value top = Value{1} << (bits - 1);
    EXPECT_EQ(sat(top, bits), top - 1);
    EXPECT_EQ(sat(top - 1, bits), top - 1);
    EXPECT_EQ(sat(-top, bits), -top);
    EXPECT_EQ(sat(-top - 1, bits), -top);
  }
}

TEST(Lerp, StaysBetweenItsEndsAndWithinHalfAUnit) {
  for (Value a = 0; a < 256; a += 5) {
    for (Value b = 0; b < 256; b += 3) {
      for (Value f = 0; f < 256; ++f) {
        const Value near = lerp(Rounding::nearest, a, b, f);
        const Value low = lerp(Rounding::truncate, a, b, f);
        const Value exact = 256 * a + (b - a) * f;  // in 2^-8
        ASSERT_LE(std::abs(256 * near - exact), 128);
        ASSERT_LE(256 * low, exact);
        ASSERT_LT(exact - 256 * low, 256);
        ASSERT_GE(std::min(near, low), std::min(a, b));
        ASSERT_LE(std::max(near, low), std::max(a, b));
      }
    }
  }
}

}  // namespace
}  // namespace ptm::reference
