#include "model/quantize/mip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "model/quantize/choose_grid.h"
#include "model/quantize/quantize.h"
#include "tests/quantize/synthetic_map.h"

namespace ptm::quantize {
namespace {

using tests::synthetic_coefficients;
using tests::view;

TEST(Halve, AveragesPairsAndSharesTheMiddleOfOddSides) {
  EXPECT_EQ(halve(std::vector<double>{1, 3, 5, 7}, 2, 2, 1), (std::vector<double>{4}));
  EXPECT_EQ(halve(std::vector<double>{1, 3, 5, 7}, 4, 1, 1), (std::vector<double>{2, 6}));
  EXPECT_EQ(halve(std::vector<double>{3, 6, 12}, 3, 1, 1), (std::vector<double>{7}));
  // Five to two: each covers two and a half.
  const std::vector<double> five = halve(std::vector<double>{10, 20, 30, 40, 50}, 1, 5, 1);
  ASSERT_EQ(five.size(), 2U);
  EXPECT_NEAR(five[0], (10 + 20 + 15) / 2.5, 1e-12);
  EXPECT_NEAR(five[1], (15 + 40 + 50) / 2.5, 1e-12);
  EXPECT_EQ(halve(std::vector<double>{1, 2, 3, 4}, 2, 1, 2), (std::vector<double>{2, 3}));
}

TEST(Halve, RefusesSizesThatDoNotAgree) {
  EXPECT_THROW((void)halve(std::vector<double>(5), 2, 2, 1), std::invalid_argument);
  EXPECT_THROW((void)halve(std::vector<double>{}, 0, 2, 1), std::invalid_argument);
}

double luminance(const double* a, double lu, double lv) {
  const auto b = basis(lu, lv);
  double l = 0;
  for (std::size_t i = 0; i < kSix; ++i) l += a[i] * b[static_cast<Eigen::Index>(i)];
  return l;
}

TEST(MipLevels, LightAverageTexelsAsTheAverageOfLitTexelsAtAnySize) {
  for (const auto& [width, height] : {std::pair{16, 8}, {13, 7}, {5, 1}, {1, 9}, {3, 3}}) {
    const std::vector<double> real = synthetic_coefficients(width, height, 7, 3);
    const auto levels = mip_levels(view(real, width, height, 3));
    for (const auto& [lu, lv] : {std::pair{0.0, 0.0}, {0.7, -0.4}, {-0.6, 0.8}}) {
      // Luminance of every texel, then halved like a picture.
      std::vector<double> lit;
      for (std::size_t k = 0; k < real.size(); k += kSix)
        lit.push_back(luminance(&real[k], lu, lv));
      int w = width, h = height;
      for (const RealLevel& level : levels) {
        lit = halve(lit, w, h, 3);
        w = level.width;
        h = level.height;
        ASSERT_EQ(level.coef.size(), lit.size() * kSix);
        for (std::size_t p = 0; p < lit.size(); ++p) {
          ASSERT_NEAR(luminance(&level.coef[p * kSix], lu, lv), lit[p], 1e-9);
        }
      }
      EXPECT_EQ(w, 1);
      EXPECT_EQ(h, 1);
    }
  }
  EXPECT_TRUE(mip_levels(view(std::vector<double>(6), 1, 1)).empty());
}

TEST(MipLevels, KeepTheMeanOfTheWholeMapAndAreHeldByItsGridWithoutSaturation) {
  const std::vector<double> real = synthetic_coefficients(45, 31, 2);
  const Gram g = hemisphere_gram();
  const Grid grid = range_grid(view(real, 45, 31), reference::EvalConfig{});
  Six<double> mean{};
  for (std::size_t k = 0; k < real.size(); ++k) mean[k % kSix] += real[k] / (45.0 * 31);
  const auto levels = mip_levels(view(real, 45, 31));
  EXPECT_EQ(levels.size(), 5U);
  for (std::size_t i = 0; i < kSix; ++i) EXPECT_NEAR(levels.back().coef[i], mean[i], 1e-9);
  for (const RealLevel& level : levels) {
    const StoredMap stored =
        quantize_on_grid(level.view(), grid, reference::EvalConfig{}, Method::plain, g);
    EXPECT_EQ(stored.saturated, Six<std::uint64_t>{});
    const std::vector<double> held = dequantize(stored);
    for (std::size_t k = 0; k < level.coef.size(); ++k) {
      const double off = held[k] - level.coef[k];
      ASSERT_LE(std::abs(off), std::ldexp(0.5, -grid.shift[k % kSix]));
    }
  }
}

}  // namespace
}  // namespace ptm::quantize
