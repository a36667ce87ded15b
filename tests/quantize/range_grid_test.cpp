#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "model/quantize/choose_grid.h"
#include "model/quantize/quantize.h"
#include "tests/quantize/synthetic_map.h"

namespace ptm::quantize {
namespace {

using reference::EvalConfig;
using tests::synthetic_coefficients;
using tests::view;

std::uint64_t saturated(const std::vector<double>& real, int side, const Grid& grid,
                        const EvalConfig& config, std::size_t i) {
  return quantize_on_grid(view(real, side, side), grid, config, Method::plain, hemisphere_gram())
      .saturated[i];
}

/// Whether any bias holds every value of coefficient i at this shift.
bool some_bias_fits(const std::vector<double>& real, int shift, const EvalConfig& config,
                    std::size_t i) {
  std::vector<double> values;
  for (std::size_t k = i; k < real.size(); k += kSix) values.push_back(real[k]);
  for (const double saturation : bias_costs(values, shift, config).saturation) {
    if (saturation == 0) return true;
  }
  return false;
}

TEST(RangeGrid, IsTheFinestAtWhichNothingSaturatesForEveryConfiguration) {
  std::mt19937 random(17);
  const auto in = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  for (int round = 0; round < 100; ++round) {
    EvalConfig c;
    c.coef_bits = in(4, 12);
    c.delta_bits = in(5, 13);
    c.shift_min = -8;
    c.shift_groups = in(0, 1) ? 3 : 6;
    const auto real = synthetic_coefficients(9, 9, static_cast<std::uint32_t>(round));
    const Grid grid = range_grid(view(real, 9, 9), c);
    check_grid(grid, c);
    for (std::size_t i = 0; i < kSix; ++i) {
      EXPECT_EQ(saturated(real, 9, grid, c, i), 0U) << round << ' ' << i;
    }
    for (std::size_t i = 0; i < kSix; ++i) {
      bool all_fit_finer = grid.shift[i] < reference::kShiftMax;
      for (const std::size_t member : shift_group(c, i)) {
        all_fit_finer = all_fit_finer && some_bias_fits(real, grid.shift[i] + 1, c, member);
      }
      EXPECT_FALSE(all_fit_finer) << round << ' ' << i;
    }
  }
}

TEST(RangeGrid, TakesTheCoarsestShiftForValuesTooLargeAndRefusesNone) {
  const Grid grid = range_grid(view(std::vector<double>(6, 1e9), 1, 1), EvalConfig{});
  for (const int shift : grid.shift) EXPECT_EQ(shift, EvalConfig{}.shift_min);
  EXPECT_THROW((void)range_grid(view(std::vector<double>(6, NAN), 1, 1), EvalConfig{}),
               std::invalid_argument);
}

TEST(BestShift, IsTheCoarsestForValuesBeyondEveryShift) {
  // Of both signs and beyond the limit to which distances are told apart: coarser windows reach
  // further, so each of them saturates less.
  const EvalConfig config;
  for (const double size : {1e5, 1e9, 1e12, 1e15, 1e100, 1e300}) {
    std::vector<double> real = synthetic_coefficients(8, 8, 3);
    for (double& a : real) a *= size;
    const StoredMap stored =
        quantize(view(real, 8, 8), config, Method::nearest_plane, hemisphere_gram());
    for (const int shift : stored.shift) EXPECT_EQ(shift, config.shift_min) << size;
  }
}

}  // namespace
}  // namespace ptm::quantize
