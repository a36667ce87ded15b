#include "model/quantize/grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "model/quantize/choose_grid.h"

namespace ptm::quantize {
namespace {

using reference::EvalConfig;

/// The definition of best_bias(), by trying everything.
double brute_error(const std::vector<double>& values, int shift, int bias, const EvalConfig& c) {
  const int top = (1 << c.coef_bits) - 1, half = 1 << (c.delta_bits - 1);
  double error = 0;
  for (const double v : values) {
    double d = std::floor(v * std::ldexp(1.0, shift) + 0.5);
    d = std::clamp<double>(d, std::max(-bias, -half), std::min(top - bias, half - 1));
    const double e = d * std::ldexp(1.0, -shift) - v;
    error += e * e;
  }
  return error;
}

TEST(BiasCosts, FindsTheLeastErrorThatTryingEveryBiasFinds) {
  std::mt19937 random(7);
  for (int round = 0; round < 60; ++round) {
    EvalConfig config;
    config.coef_bits = 4 + static_cast<int>(random() % 5);
    config.delta_bits = 5 + static_cast<int>(random() % 6);
    const int shift = static_cast<int>(random() % 8) - 3;
    const double centre = static_cast<double>(random() % 400) - 200;
    std::normal_distribution<double> value(centre, 1 + static_cast<double>(random() % 100));
    std::vector<double> values(50);
    for (double& v : values) v = value(random);
    double least = INFINITY;
    for (int bias = 0; bias < 1 << config.coef_bits; ++bias) {
      least = std::min(least, brute_error(values, shift, bias, config));
    }
    const BiasCosts costs = bias_costs(values, shift, config);
    const double tolerance = 1e-8 * (1 + least);
    EXPECT_NEAR(costs.least(), least, tolerance) << "round " << round;
    EXPECT_NEAR(brute_error(values, shift, costs.best, config), least, tolerance) << round;
  }
}

TEST(BiasCosts, LeaveRoomAtBothEndsWhenSeveralBiasesAreAsGood) {
  const std::vector<double> values{-1, 0, 1};
  EXPECT_NEAR(bias_costs(values, 0, EvalConfig{}).best, 128, 1);
}

TEST(BiasCosts, Prefer128ForFullRangeDeltasOfEightBits) {
  const std::vector<double> values{-128, -3, 0, 127};
  const BiasCosts costs = bias_costs(values, 0, reference::kPaper8);
  EXPECT_EQ(costs.best, 128);
  EXPECT_EQ(costs.least(), 0);
}

int shift_of(const std::vector<double>& values) {
  const std::vector<Population> one{Population(values, 1.0)};
  return best_shift(one, EvalConfig{});
}

TEST(BestShift, IsTheFinestThatHoldsTheRangeWhenNothingMaySaturate) {
  // 201 values evenly from -100 to 100: 8 bits hold them at shift 0, not at shift 1.
  std::vector<double> values;
  for (int v = -100; v <= 100; ++v) values.push_back(v + 0.3);
  EXPECT_EQ(shift_of(values), 0);
}

TEST(BestShift, SaturatesASliverOfTheRangeWhereThatCostsLessThanABit) {
  // The range is 266 steps of 1/2; giving up a bit would cost all values, the end costs two a bit.
  std::vector<double> values(900, 0.5);
  for (int k = 0; k < 120; ++k) values.push_back(-60 + 1.01 * k);
  values.push_back(-65.2);
  values.push_back(67.8);
  EXPECT_EQ(shift_of(values), 1);
}

TEST(BestShift, IsZeroForNothing) { EXPECT_EQ(shift_of({0, 0, 0}), 0); }

/// Even values over 0..999 and two far away, in a map of 8,192.
std::vector<double> with_two_outliers(double far) {
  std::vector<double> values;
  for (int k = 0; k < 8192; ++k) values.push_back((k % 1000) * 0.999);
  values[5] = far;
  values[6] = -far;
  return values;
}

TEST(BestShift, SacrificesTwoOutliersToTheOthersBits) {
  const int without = shift_of(with_two_outliers(500));
  EXPECT_EQ(shift_of(with_two_outliers(1e9)), without);
  EXPECT_EQ(shift_of(with_two_outliers(8000)), without);
}

TEST(BestShift, KeepsOutliersThatCostTheOthersNothing) {
  // Whole numbers from 0 to 99 are as exact at shift 0 as at shift 1; 150 fits only the former.
  std::vector<double> values;
  for (int k = 0; k < 8192; ++k) values.push_back(k % 100);
  values[17] = 150;
  EXPECT_EQ(shift_of(values), 0);
}

TEST(Population, LimitsOnlyTheFewValuesFarFromTheOthers) {
  const Population p(with_two_outliers(1e9), 1.0);
  ASSERT_TRUE(p.has_outliers());
  const auto kept = p.typical();
  EXPECT_NEAR(kept[5], 998 * (1 + 1.0 / 16), 1.0);
  EXPECT_NEAR(kept[6], -998.0 / 16, 1.0);
  for (std::size_t k = 7; k < kept.size(); ++k) ASSERT_EQ(kept[k], p.all()[k]);
}

TEST(Population, HasNoOutliersInASmallMapOrWhereNoneStandsOut) {
  EXPECT_FALSE(Population({0, 1, 1e9}, 1.0).has_outliers());
  EXPECT_FALSE(Population(with_two_outliers(0), 1.0).has_outliers());
  EXPECT_FALSE(Population(std::vector<double>(5000, 3.0), 1.0).has_outliers());
}

TEST(CheckGrid, RefusesWhatTheConfigurationCannotHold) {
  EvalConfig three;
  three.shift_groups = 3;
  Grid good;
  EXPECT_NO_THROW(check_grid(good, three));
  Grid bias = good, shift = good, group = good;
  bias.bias[2] = 256;
  shift.shift[4] = 16;
  group.shift[1] = 1;
  for (const Grid& bad : {bias, shift, group}) {
    EXPECT_THROW(check_grid(bad, three), std::invalid_argument);
  }
  EXPECT_NO_THROW(check_grid(group, EvalConfig{}));
}

}  // namespace
}  // namespace ptm::quantize
