#include "model/quantize/grid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/quantize/wide.h"

namespace ptm::quantize {
namespace {

using reference::EvalConfig;

/// Moments of the scaled values x that round to one integer, or of a run of such.
struct Moments {
  double count = 0, sum = 0, squares = 0;
  double rounding = 0;  ///< sum of (x - round(x))^2

  void add(const Moments& m) {
    count += m.count;
    sum += m.sum;
    squares += m.squares;
    rounding += m.rounding;
  }
  /// sum of (x - end)^2; the expansion may cancel to just below zero.
  [[nodiscard]] double distance(double end) const {
    return std::max(0.0, squares - 2 * end * sum + end * end * count);
  }
};

constexpr std::size_t kBlock = 256;  ///< values whose moments wait for their bins

/// Moments of single values, and the bin of each.
struct Block {
  std::array<double, kBlock> x, squares, rounding;
  std::array<std::int32_t, kBlock> bin;
};

PTM_QUANTIZE_WIDE void measure(const double* values, std::size_t count, double scale, double last,
                               Block& block) {
  // Far outside every window the exact distance no longer decides; squares must stay finite. The
  // value itself is limited, not the scaled one: what saturates at every shift must cost less at a
  // coarse one, whose windows reach further.
  constexpr double kFar = 0x1p40;
  for (std::size_t t = 0; t < count; ++t) {
    const double raised = values[t] > -kFar ? values[t] : -kFar;
    const double x = (raised < kFar ? raised : kFar) * scale;
    const double rounded = std::floor(x + 0.5);
    const double first = rounded > -last ? rounded : -last;
    block.bin[t] = static_cast<std::int32_t>((first < last ? first : last) + last);
    block.x[t] = x;
    block.squares[t] = x * x;
    block.rounding[t] = (x - rounded) * (x - rounded);
  }
}

/// Bin k holds the values that round to k - reach; the outermost bins hold everything beyond, and
/// no window includes them.
std::vector<Moments> histogram(std::span<const double> values, int shift, int reach) {
  const double scale = std::ldexp(1.0, shift), last = reach;
  std::vector<Moments> bins(static_cast<std::size_t>(2 * reach + 1));
  Block block;
  for (std::size_t first = 0; first < values.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, values.size() - first);
    measure(values.data() + first, count, scale, last, block);
    for (std::size_t t = 0; t < count; ++t) {
      bins[static_cast<std::size_t>(block.bin[t])].add(
          {1, block.x[t], block.squares[t], block.rounding[t]});
    }
  }
  return bins;
}

constexpr std::array<std::size_t, 6> kEach{0, 1, 2, 3, 4, 5};

}  // namespace

int coef_top(const EvalConfig& config) { return (1 << config.coef_bits) - 1; }

Window delta_window(const EvalConfig& config, int bias) {
  const int half = 1 << (config.delta_bits - 1);
  return {std::max(-bias, -half), std::min(coef_top(config) - bias, half - 1)};
}

std::span<const std::size_t> shift_group(const EvalConfig& config, std::size_t i) {
  const std::span<const std::size_t> all(kEach);
  if (config.shift_groups == 6) return all.subspan(i, 1);
  return i < 3 ? all.subspan(0, 3) : i < 5 ? all.subspan(3, 2) : all.subspan(5, 1);
}

void check_size(int width, int height, int polynomials, std::size_t values) {
  if (width <= 0 || height <= 0 || (polynomials != 1 && polynomials != 3)) {
    throw std::invalid_argument("a map of " + std::to_string(width) + " x " +
                                std::to_string(height) + " texels, " + std::to_string(polynomials) +
                                " polynomials");
  }
  const std::size_t expected = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                               static_cast<std::size_t>(polynomials) * kSix;
  if (values != expected) {
    throw std::invalid_argument("a map of " + std::to_string(values) + " coefficients, expected " +
                                std::to_string(expected));
  }
}

void check_finite(std::span<const double> coef) {
  // The exponent of what is not finite is all ones, so that one more reaches the sign's place;
  // looking at all of them at once is several times as fast as asking one by one.
  constexpr std::uint64_t kExponent = 0x7FF0000000000000, kOne = 0x0010000000000000;
  std::uint64_t carries = 0;
  for (const double a : coef) carries |= (std::bit_cast<std::uint64_t>(a) & kExponent) + kOne;
  if (carries >> 63 == 0) return;
  const auto odd =
      std::find_if_not(coef.begin(), coef.end(), [](double a) { return std::isfinite(a); });
  const auto k = static_cast<std::size_t>(odd - coef.begin());
  throw std::invalid_argument("coefficient " + std::to_string(k % kSix) + " of polynomial " +
                              std::to_string(k / kSix) + " is not finite");
}

void check_grid(const Grid& grid, const EvalConfig& config) {
  for (std::size_t i = 0; i < kSix; ++i) {
    const bool bias_fits = grid.bias[i] >= 0 && grid.bias[i] <= coef_top(config);
    const bool shift_fits =
        grid.shift[i] >= config.shift_min && grid.shift[i] <= reference::kShiftMax;
    const std::size_t first = shift_group(config, i).front();
    if (!bias_fits || !shift_fits || grid.shift[i] != grid.shift[first]) {
      throw std::invalid_argument("coefficient " + std::to_string(i) + " with bias " +
                                  std::to_string(grid.bias[i]) + " and shift " +
                                  std::to_string(grid.shift[i]) + " is not for this hardware");
    }
  }
}

BiasCosts bias_costs(std::span<const double> values, int shift, const EvalConfig& config) {
  const int top = coef_top(config), reach = top + 1;
  const std::vector<Moments> bins = histogram(values, shift, reach);
  // below[k]: all bins under k; above[k]: all bins from k on. Summed from their own ends, so that
  // an empty end is exactly zero.
  std::vector<Moments> below(bins.size() + 1), above(bins.size() + 1);
  for (std::size_t k = 0; k < bins.size(); ++k) {
    below[k + 1] = below[k];
    below[k + 1].add(bins[k]);
    const std::size_t j = bins.size() - 1 - k;
    above[j] = above[j + 1];
    above[j].add(bins[j]);
  }
  const double unit = std::ldexp(1.0, -2 * shift);
  BiasCosts costs;
  costs.saturation.reserve(static_cast<std::size_t>(top) + 1);
  costs.error.reserve(static_cast<std::size_t>(top) + 1);
  for (int bias = 0; bias <= top; ++bias) {
    const Window window = delta_window(config, bias);
    const auto low = static_cast<std::size_t>(window.low + reach);
    const auto high = static_cast<std::size_t>(window.high + reach);
    const double outside = below[low].distance(window.low) + above[high + 1].distance(window.high);
    const double inside = std::max(0.0, below[high + 1].rounding - below[low].rounding);
    costs.saturation.push_back(outside * unit);
    costs.error.push_back((outside + inside) * unit);
  }
  const double least = *std::min_element(costs.error.begin(), costs.error.end());
  const auto equal = [&](double e) { return e <= least * (1 + 1e-9); };
  const auto first = std::find_if(costs.error.begin(), costs.error.end(), equal);
  const auto end = std::find_if_not(first, costs.error.end(), equal);
  costs.best = static_cast<int>((first - costs.error.begin()) + (end - first - 1) / 2);
  return costs;
}

}  // namespace ptm::quantize
