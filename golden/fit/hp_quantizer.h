#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>

namespace ptm::golden {

/// The ranges of the six coefficients over a whole map.
struct CoefficientRange {
  std::array<double, 6> low, high;
  CoefficientRange() {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
  }
  void add(std::span<const double> coef);  ///< [..][6]
  void add(const CoefficientRange& other);
};

/// Scale and bias of HP's fitter, for comparison with it: docs/spec/fit.md, Q2.
///
///     range = high - low = m 2^e, 1/2 <= m < 1      scale = 2^(e - 8)
///     low < 0:  bias = int(-low / scale + 1), the scale doubled until bias <= 255
///     else:     bias = 0, the scale doubled until high / scale <= 255
///
/// A range of 0 gets scale 2^-8 to begin with, so no scale is 0 or infinite.
struct HpGrid {
  std::array<double, 6> scale{};
  std::array<std::int32_t, 6> bias{};
};
[[nodiscard]] HpGrid hp_grid(const CoefficientRange& range);

/// byte = floor(a / scale + bias + 1/2), clamped to 0..255 and then counted in `saturated` (HP's
/// fitter keeps the low eight bits instead).
void hp_store(std::span<const double> coef, const HpGrid& grid, std::span<std::uint8_t> bytes,
              std::array<std::uint64_t, 6>& saturated);

}  // namespace ptm::golden
