#include "model/quantize/quantize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>
#include <random>
#include <stdexcept>

#include "tests/quantize/synthetic_map.h"

namespace ptm::quantize {
namespace {

using reference::EvalConfig;
using tests::synthetic_coefficients;
using tests::view;

/// Asserts what StoredMap promises for any configuration.
void expect_storable(const StoredMap& map, const EvalConfig& config) {
  check_grid({map.bias, map.shift}, config);
  for (std::size_t k = 0; k < map.coef.size(); ++k) {
    const int delta = map.coef[k] - map.bias[k % kSix];
    ASSERT_LT(map.coef[k], 1 << config.coef_bits);
    ASSERT_GE(delta, -(1 << (config.delta_bits - 1)));
    ASSERT_LT(delta, 1 << (config.delta_bits - 1));
  }
}

double g_norm(const Six<double>& e, const Gram& g) {
  Eigen::Matrix<double, 6, 1> v;
  for (std::size_t i = 0; i < kSix; ++i) v[static_cast<Eigen::Index>(i)] = e[i];
  return v.dot(g * v);
}

TEST(Quantize, GivesBackCoefficientsThatLieOnAGridExactly) {
  std::mt19937 random(3);
  const Six<double> step{0.5, 0.25, 1, 2, 0.125, 4};
  std::vector<double> real;
  for (int t = 0; t < 500; ++t) {
    for (const double s : step) real.push_back(s * (static_cast<double>(random() % 256) - 100));
  }
  for (const Method method : {Method::plain, Method::nearest_plane}) {
    const StoredMap map = quantize(view(real, 50, 10), EvalConfig{}, method, hemisphere_gram());
    EXPECT_EQ(dequantize(map), real);
    EXPECT_EQ(map.rms_error, 0);
    EXPECT_EQ(map.saturated, Six<std::uint64_t>{});
  }
}

TEST(Quantize, PlainRoundsEachCoefficientToItsNearestStep) {
  const std::vector<double> real = synthetic_coefficients(32, 32, 1);
  const StoredMap map =
      quantize(view(real, 32, 32), EvalConfig{}, Method::plain, hemisphere_gram());
  ASSERT_EQ(std::accumulate(map.saturated.begin(), map.saturated.end(), std::uint64_t{0}), 0U);
  const std::vector<double> stored = dequantize(map);
  for (std::size_t k = 0; k < real.size(); ++k) {
    ASSERT_LE(std::abs(stored[k] - real[k]), std::ldexp(0.5, -map.shift[k % kSix]));
  }
}

TEST(Quantize, NearestPlaneKeepsItsBoundAndLiesBetweenTheBestAndPlainOnAverage) {
  // On one grid: the best of all integers within 2 steps of each coefficient, for 150 texels.
  const std::vector<double> real = synthetic_coefficients(15, 10, 5);
  const Gram g = hemisphere_gram(), r = gram_factor(g);
  const StoredMap nearest = quantize(view(real, 15, 10), EvalConfig{}, Method::nearest_plane, g);
  const Grid grid{nearest.bias, nearest.shift};
  const StoredMap plain =
      quantize_on_grid(view(real, 15, 10), grid, EvalConfig{}, Method::plain, g);
  ASSERT_EQ(nearest.saturated, Six<std::uint64_t>{});
  double bound = 0;
  Six<double> step{};
  for (std::size_t i = 0; i < kSix; ++i) {
    step[i] = std::ldexp(1.0, -grid.shift[i]);
    const auto d = static_cast<Eigen::Index>(i);
    bound += std::pow(r(d, d) * step[i], 2) / 4;
  }
  const std::vector<double> a = dequantize(nearest), b = dequantize(plain);
  double sum_best = 0, sum_nearest = 0, sum_plain = 0;
  for (std::size_t k = 0; k < real.size(); k += kSix) {
    Six<double> ea{}, eb{};
    for (std::size_t i = 0; i < kSix; ++i) {
      ea[i] = a[k + i] - real[k + i];
      eb[i] = b[k + i] - real[k + i];
    }
    double best = INFINITY;
    for (int n = 0; n < 15625; ++n) {
      Six<double> e = eb;
      for (int i = 0, digits = n; i < 6; ++i, digits /= 5) {
        e[static_cast<std::size_t>(i)] += (digits % 5 - 2) * step[static_cast<std::size_t>(i)];
      }
      best = std::min(best, g_norm(e, g));
    }
    ASSERT_LE(g_norm(ea, g), bound * (1 + 1e-12));
    ASSERT_GE(g_norm(ea, g), best * (1 - 1e-12));
    sum_best += best;
    sum_nearest += g_norm(ea, g);
    sum_plain += g_norm(eb, g);
  }
  EXPECT_LT(sum_nearest, sum_plain);
  std::cout << "mean squared error, best : nearest plane : plain = 1 : " << sum_nearest / sum_best
            << " : " << sum_plain / sum_best << '\n';
}

TEST(Quantize, NearestPlaneGainsDecibelsOverPlainRoundingOnALitRelief) {
  const std::vector<double> real = synthetic_coefficients(192, 192, 11);
  const Gram g = hemisphere_gram();
  for (const auto& [name, config] : reference::kPresets) {
    const RealMap map = view(real, 192, 192);
    const auto plain = compare(map, quantize(map, config, Method::plain, g), g);
    const auto nearest = compare(map, quantize(map, config, Method::nearest_plane, g), g);
    std::cout << name << ": plain " << plain.psnr_db << " dB, nearest plane " << nearest.psnr_db
              << " dB, gain " << nearest.psnr_db - plain.psnr_db << " dB\n";
    EXPECT_GT(nearest.psnr_db, plain.psnr_db);
  }
}

/// The luminance error of the texels from `first` to before `last`, over the hemisphere.
double rms_of(const std::vector<double>& real, const StoredMap& stored, std::size_t first,
              std::size_t last, const Gram& g) {
  const auto cut = [&](const auto& v) {
    return std::decay_t<decltype(v)>(v.begin() + static_cast<std::ptrdiff_t>(first * kSix),
                                     v.begin() + static_cast<std::ptrdiff_t>(last * kSix));
  };
  StoredMap part = stored;
  part.coef = cut(stored.coef);
  const std::vector<double> real_part = cut(real);
  return compare(view(real_part, static_cast<int>(last - first), 1), part, g).rms;
}

TEST(Quantize, AFewOutliersSaturateAreCountedAndCostTheOthersNothing) {
  const int size = 128;
  std::vector<double> real = synthetic_coefficients(size, size, 2);
  const Gram g = hemisphere_gram();
  for (const Method method : {Method::plain, Method::nearest_plane}) {
    const StoredMap clean = quantize(view(real, size, size), EvalConfig{}, method, g);
    std::vector<double> spoilt = real;
    for (const std::size_t texel : {77U, 5000U, 16000U}) {
      for (std::size_t i = 0; i < kSix; ++i) spoilt[texel * kSix + i] = i % 2 ? 1e5 : -1e5;
    }
    const StoredMap map = quantize(view(spoilt, size, size), EvalConfig{}, method, g);
    EXPECT_EQ(map.shift, clean.shift);
    for (std::size_t i = 0; i < kSix; ++i) EXPECT_GE(map.saturated[i], 3U) << i;
    // The texels between the second and the third outlier are stored as well as before.
    EXPECT_LT(rms_of(real, map, 5001, 16000, g), 1.02 * rms_of(real, clean, 5001, 16000, g));
  }
}

TEST(Quantize, HoldsMapsWithNothingInThem) {
  const Gram g = hemisphere_gram();
  const std::vector<double> zero(6, 0.0), equal(60, 77.7), huge(6, 1e308);
  const StoredMap none = quantize(view(zero, 1, 1), EvalConfig{}, Method::nearest_plane, g);
  EXPECT_EQ(dequantize(none), zero);
  EXPECT_EQ(none.shift, Six<int>{});
  const StoredMap flat = quantize(view(equal, 10, 1), EvalConfig{}, Method::nearest_plane, g);
  EXPECT_LT(flat.rms_error, 0.25);
  const StoredMap top = quantize(view(huge, 1, 1), EvalConfig{}, Method::nearest_plane, g);
  expect_storable(top, EvalConfig{});
  EXPECT_GE(top.saturated[5], 1U);
  EXPECT_TRUE(std::isfinite(top.rms_error));
}

TEST(Quantize, ServesEveryConfigurationInTheStatedRanges) {
  std::mt19937 random(99);
  const auto in = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  for (int round = 0; round < 200; ++round) {
    EvalConfig c;
    c.coef_bits = in(4, 12);
    c.delta_bits = in(5, 13);
    c.shift_min = in(-8, 0);
    c.shift_groups = in(0, 1) ? 3 : 6;
    const int polynomials = in(0, 1) ? 3 : 1;
    const std::vector<double> real =
        synthetic_coefficients(9, 7, static_cast<std::uint32_t>(round), polynomials);
    for (const Method method : {Method::plain, Method::nearest_plane}) {
      const StoredMap map = quantize(view(real, 9, 7, polynomials), c, method, hemisphere_gram());
      expect_storable(map, c);
      EXPECT_EQ(map.coef.size(), real.size());
    }
  }
}

TEST(Quantize, EachBitMoreHalvesTheErrorWhereNothingElseLimits) {
  const std::vector<double> real = synthetic_coefficients(48, 48, 21);
  double before = INFINITY;
  for (int bits = 4; bits <= 12; ++bits) {
    EvalConfig c;
    c.coef_bits = bits;
    c.delta_bits = std::max(5, bits + 1);
    c.shift_min = -8;
    const double rms =
        quantize(view(real, 48, 48), c, Method::nearest_plane, hemisphere_gram()).rms_error;
    EXPECT_LT(rms, 0.62 * before) << bits;  // saturation of a sliver keeps it from 0.5 sharp
    before = rms;
  }
}

TEST(Quantize, OnItsOwnGridGivesTheSameIntegers) {
  const std::vector<double> real = synthetic_coefficients(20, 20, 8, 3);
  const Gram g = hemisphere_gram();
  const StoredMap map = quantize(view(real, 20, 20, 3), EvalConfig{}, Method::nearest_plane, g);
  const StoredMap again = quantize_on_grid(view(real, 20, 20, 3), {map.bias, map.shift},
                                           EvalConfig{}, Method::nearest_plane, g);
  EXPECT_EQ(again.coef, map.coef);
  EXPECT_EQ(again.saturated, map.saturated);
}

TEST(Quantize, RecordsTheErrorThatEvaluatingUnderManyLightsShows) {
  const std::vector<double> real = synthetic_coefficients(16, 16, 4);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-0.7, 0.7);
  std::vector<std::array<double, 2>> lights(30);
  for (auto& light : lights) light = {coordinate(random), coordinate(random)};
  const StoredMap map =
      quantize(view(real, 16, 16), EvalConfig{}, Method::nearest_plane, gram_of_lights(lights));
  const std::vector<double> stored = dequantize(map);
  double squares = 0;
  for (const auto& [lu, lv] : lights) {
    const auto b = basis(lu, lv);
    for (std::size_t k = 0; k < real.size(); k += kSix) {
      double e = 0;
      for (std::size_t i = 0; i < kSix; ++i) {
        e += (stored[k + i] - real[k + i]) * b[static_cast<Eigen::Index>(i)];
      }
      squares += e * e;
    }
  }
  EXPECT_NEAR(map.rms_error, std::sqrt(squares / (30.0 * 256)), 1e-9);
}

TEST(Quantize, RefusesCoefficientsThatAreNotFiniteAndWrongSizes) {
  const Gram g = hemisphere_gram();
  for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY)}) {
    std::vector<double> real = synthetic_coefficients(4, 4, 1);
    real[50] = bad;
    EXPECT_THROW((void)quantize(view(real, 4, 4), EvalConfig{}, Method::plain, g),
                 std::invalid_argument);
  }
  const std::vector<double> real = synthetic_coefficients(4, 4, 1);
  EXPECT_THROW((void)quantize(view(real, 4, 5), EvalConfig{}, Method::plain, g),
               std::invalid_argument);
  EXPECT_THROW((void)quantize(view(real, 0, 0), EvalConfig{}, Method::plain, g),
               std::invalid_argument);
  EvalConfig config;
  config.delta_bits = 14;
  EXPECT_THROW((void)quantize(view(real, 4, 4), config, Method::plain, g), std::invalid_argument);
}

}  // namespace
}  // namespace ptm::quantize
