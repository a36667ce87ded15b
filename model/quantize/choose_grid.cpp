#include "model/quantize/choose_grid.h"

#include <algorithm>
#include <cmath>

namespace ptm::quantize {
namespace {

using reference::EvalConfig;
using reference::kShiftMax;

constexpr std::size_t kOutlierShare = 4096;  ///< one value in so many, at either end
constexpr std::size_t kFewestForOne = 1024;  ///< from here on at least one
constexpr double kOutlierFence = 1.0 / 16;   ///< of the spread of the others
/// Outliers saturate if that saves the others this factor of squared error; a bit is a factor 4.
constexpr double kWorthSaturating = 2;

/// The finest shift at which values between low and high fit some bias; below shift_min if none.
int widest_shift(double low, double high, const EvalConfig& config) {
  const int top = coef_top(config), half = 1 << (config.delta_bits - 1);
  for (int shift = kShiftMax; shift >= config.shift_min; --shift) {
    const double first = std::floor(std::ldexp(low, shift) + 0.5);
    const double last = std::floor(std::ldexp(high, shift) + 0.5);
    const double below = std::max(0.0, -first), above = std::max(0.0, last);
    if (below <= half && above <= half - 1 && below + above <= top) return shift;
  }
  return config.shift_min - 1;
}

using Part = Population::Part;

struct Choice {
  int shift = 0;
  double error = 0;
};

double weighted_error(std::span<const Population> coefficients, Part part, int shift,
                      const EvalConfig& config, double* saturation = nullptr) {
  double error = 0;
  for (const Population& coefficient : coefficients) {
    const BiasCosts& costs = coefficient.costs(part, shift, config);
    error += coefficient.weight() * costs.least();
    if (saturation != nullptr) {
      *saturation += coefficient.weight() * costs.saturation[static_cast<std::size_t>(costs.best)];
    }
  }
  return error;
}

Choice search(std::span<const Population> coefficients, Part part, const EvalConfig& config) {
  int start = kShiftMax;
  bool zero = true;
  for (const Population& coefficient : coefficients) {
    const auto values = part == Part::all ? coefficient.all() : coefficient.typical();
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    start = std::min(start, widest_shift(*low, *high, config));
    zero = zero && *low == 0 && *high == 0;
  }
  if (zero) return {0, 0.0};
  Choice best{std::max(start, config.shift_min), INFINITY};
  for (int shift = best.shift; shift <= kShiftMax; ++shift) {
    double saturation = 0;
    const double error = weighted_error(coefficients, part, shift, config, &saturation);
    if (error < best.error) best = {shift, error};
    if (saturation > best.error) break;
  }
  return best;
}

/// The values with those far outside the others' spread moved to its limit; empty if there are
/// none.
std::vector<double> limit_outliers(const std::vector<double>& values) {
  const std::size_t n = values.size();
  const std::size_t spare = std::max(n / kOutlierShare, std::size_t{n >= kFewestForOne ? 1U : 0U});
  if (spare == 0) return {};
  std::vector<double> kept = values;
  const auto at = [&](std::size_t k) { return kept.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(kept.begin(), at(spare), kept.end());
  const double low = *at(spare);
  std::nth_element(at(spare), at(n - 1 - spare), kept.end());
  const double high = *at(n - 1 - spare);
  const double fence = (high - low) * kOutlierFence;
  if (!std::isfinite(fence)) return {};
  const double least = low - fence, most = high + fence;
  if (std::all_of(values.begin(), values.end(),
                  [&](double v) { return v >= least && v <= most; })) {
    return {};
  }
  std::transform(values.begin(), values.end(), kept.begin(),
                 [&](double v) { return std::clamp(v, least, most); });
  return kept;
}

}  // namespace

Population::Population(std::vector<double> values, double weight)
    : all_(std::move(values)), typical_(limit_outliers(all_)), weight_(weight) {}

const BiasCosts& Population::costs(Part part, int shift, const EvalConfig& config) const {
  if (!has_outliers()) part = Part::all;
  for (const Known& known : known_) {
    if (known.part == part && known.shift == shift && known.config == config) return known.costs;
  }
  const auto values = part == Part::all ? all() : typical();
  known_.push_back({part, shift, config, bias_costs(values, shift, config)});
  return known_.back().costs;
}

int best_shift(std::span<const Population> coefficients, const EvalConfig& config) {
  const Choice by_all = search(coefficients, Part::all, config);
  const bool outliers =
      std::any_of(coefficients.begin(), coefficients.end(),
                  [](const Population& coefficient) { return coefficient.has_outliers(); });
  if (!outliers) return by_all.shift;
  const Choice by_typical = search(coefficients, Part::typical, config);
  const double typical_error = weighted_error(coefficients, Part::typical, by_all.shift, config);
  return typical_error > kWorthSaturating * by_typical.error ? by_typical.shift : by_all.shift;
}

int best_bias(const Population& coefficient, int shift, const EvalConfig& config) {
  const BiasCosts& all = coefficient.costs(Part::all, shift, config);
  if (!coefficient.has_outliers()) return all.best;
  const BiasCosts& typical = coefficient.costs(Part::typical, shift, config);
  const double typical_error = typical.error[static_cast<std::size_t>(all.best)];
  return typical_error > kWorthSaturating * typical.least() ? typical.best : all.best;
}

Grid range_grid(const RealMap& real, const EvalConfig& config) {
  reference::validate(config);
  check_size(real.width, real.height, real.polynomials, real.coef.size());
  check_finite(real.coef);
  Six<double> low, high;
  low.fill(INFINITY);
  high.fill(-INFINITY);
  for (std::size_t k = 0; k < real.coef.size(); ++k) {
    low[k % kSix] = std::min(low[k % kSix], real.coef[k]);
    high[k % kSix] = std::max(high[k % kSix], real.coef[k]);
  }
  Grid grid;
  for (std::size_t i = 0; i < kSix; ++i) {
    int shift = kShiftMax;
    for (const std::size_t member : shift_group(config, i)) {
      shift = std::min(shift, widest_shift(low[member], high[member], config));
    }
    grid.shift[i] = std::max(shift, config.shift_min);
    const double first = std::floor(std::ldexp(low[i], grid.shift[i]) + 0.5);
    const double last = std::floor(std::ldexp(high[i], grid.shift[i]) + 0.5);
    const double top = coef_top(config), middle = std::floor((top - first - last) / 2);
    grid.bias[i] = static_cast<int>(std::clamp(middle, 0.0, top));
  }
  return grid;
}

}  // namespace ptm::quantize
