#include "model/quantize/dither.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "model/quantize/quantize.h"
#include "tests/quantize/synthetic_map.h"

namespace ptm::quantize {
namespace {

using reference::EvalConfig;
using tests::synthetic_coefficients;
using tests::view;

/// A slope so slight that plain steps of 1 and more show as bands.
std::vector<double> slope(int side) {
  std::vector<double> coef;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double t = 0.02 * x + 0.013 * y;
      for (const double base : {-100.0, -90.0, 20.0, 35.0, -15.0, 180.0}) coef.push_back(base + t);
    }
  }
  return coef;
}

/// RMS over lights and 8 x 8 blocks of the difference between the blocks' mean luminances.
double block_error(const std::vector<double>& real, const std::vector<double>& stored, int side) {
  const Gram g = hemisphere_gram();
  double squares = 0;
  int blocks = 0;
  for (int top = 0; top + 8 <= side; top += 8) {
    for (int left = 0; left + 8 <= side; left += 8, ++blocks) {
      Eigen::Matrix<double, 6, 1> mean = Eigen::Matrix<double, 6, 1>::Zero();
      for (int n = 0; n < 64; ++n) {
        const std::size_t texel = static_cast<std::size_t>((top + n / 8) * side + left + n % 8);
        for (std::size_t i = 0; i < kSix; ++i) {
          mean[static_cast<Eigen::Index>(i)] +=
              (stored[texel * kSix + i] - real[texel * kSix + i]) / 64;
        }
      }
      squares += mean.dot(g * mean);
    }
  }
  return std::sqrt(squares / blocks);
}

constexpr Grid kCoarse{{128, 128, 128, 128, 128, 0}, {-1, -1, -1, -1, -1, -1}};

TEST(QuantizeDithered, WithoutDitherGivesTheNearestPlaneIntegers) {
  const std::vector<double> real = synthetic_coefficients(24, 16, 3, 3);
  const Gram g = hemisphere_gram();
  const StoredMap plain = quantize(view(real, 24, 16, 3), EvalConfig{}, Method::nearest_plane, g);
  const Grid grid{plain.bias, plain.shift};
  const StoredMap none =
      quantize_dithered(view(real, 24, 16, 3), grid, EvalConfig{}, Dither::none, g);
  EXPECT_EQ(none.coef, plain.coef);
  EXPECT_EQ(none.dither, Dither::none);
}

TEST(QuantizeDithered, KeepsTheMeanOfASlopeWhereRoundingMakesSteps) {
  const int side = 64;
  const std::vector<double> real = slope(side);
  const Gram g = hemisphere_gram();
  const auto error = [&](Dither dither, double& each) {
    const StoredMap map =
        quantize_dithered(view(real, side, side), kCoarse, EvalConfig{}, dither, g);
    EXPECT_EQ(map.dither, dither);
    EXPECT_EQ(map.saturated, Six<std::uint64_t>{});
    EXPECT_GE(map.worst_error, map.rms_error);
    each = map.rms_error;
    return block_error(real, dequantize(map), side);
  };
  double each_none = 0, each_ordered = 0, each_diffused = 0;
  const double none = error(Dither::none, each_none);
  const double ordered = error(Dither::ordered, each_ordered);
  const double diffused = error(Dither::diffused, each_diffused);
  std::cout << "8 x 8 blocks off by none " << none << ", ordered " << ordered << ", diffused "
            << diffused << "; each texel by " << each_none << ", " << each_ordered << ", "
            << each_diffused << " levels RMS\n";
  EXPECT_LT(ordered, none / 2);
  EXPECT_LT(diffused, none / 4);
  EXPECT_LT(each_none, each_diffused);  // the price
}

TEST(QuantizeDithered, DiffusesTheWholeErrorSoThatMeansAreKept) {
  const Six<double> value{-100.3, -90.7, 20.4, 35.6, -15.2, 180.6};
  std::vector<double> real;
  for (int t = 0; t < 64 * 64; ++t) real.insert(real.end(), value.begin(), value.end());
  const std::vector<double> stored = dequantize(quantize_dithered(
      view(real, 64, 64), kCoarse, EvalConfig{}, Dither::diffused, hemisphere_gram()));
  Six<double> mean{};
  for (std::size_t k = 0; k < stored.size(); ++k) mean[k % kSix] += stored[k] / (64 * 64);
  // Only what leaves the map at its edges is lost: about a hundredth of its texels' errors.
  for (std::size_t i = 0; i < kSix; ++i) EXPECT_NEAR(mean[i], value[i], 0.05) << i;
}

TEST(QuantizeDithered, PassesNothingOnFromAPolynomialThatSaturates) {
  std::vector<double> real = slope(16);
  const Gram g = hemisphere_gram();
  const std::size_t outlier = 16 * 4 + 7;
  for (std::size_t i = 0; i < kSix; ++i) real[outlier * kSix + i] = 1e6;
  const StoredMap map =
      quantize_dithered(view(real, 16, 16), kCoarse, EvalConfig{}, Dither::diffused, g);
  const std::vector<double> stored = dequantize(map);
  for (std::size_t t = 0; t < 256; ++t) {
    if (t == outlier) continue;
    for (std::size_t i = 0; i < kSix; ++i) {
      ASSERT_LT(std::abs(stored[t * kSix + i] - real[t * kSix + i]), 12) << t;
    }
  }
  for (std::size_t i = 0; i < kSix; ++i) EXPECT_EQ(map.saturated[i], 1U);
}

TEST(QuantizeDithered, OfEqualTexelsStepsBetweenTwoValuesOnAnEighthOfTheThresholds) {
  // a5 = 180.25 in steps of 2 lies an eighth above 180: 8 of 64 texels take 182.
  std::vector<double> real;
  for (int t = 0; t < 64; ++t) real.insert(real.end(), {0, 0, 0, 0, 0, 180.25});
  const StoredMap map = quantize_dithered(view(real, 8, 8), kCoarse, EvalConfig{}, Dither::ordered,
                                          hemisphere_gram());
  int above = 0;
  for (std::size_t t = 0; t < 64; ++t) {
    ASSERT_TRUE(map.coef[t * kSix + 5] == 90 || map.coef[t * kSix + 5] == 91);
    above += map.coef[t * kSix + 5] == 91 ? 1 : 0;
  }
  EXPECT_EQ(above, 8);
}

}  // namespace
}  // namespace ptm::quantize
