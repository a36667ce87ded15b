#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "model/quantize/maps.h"
#include "model/reference/eval_config.h"

/// The integers that a configuration can hold: one bias and shift a coefficient, for the whole map.
namespace ptm::quantize {

/// One bias and shift for each coefficient; every level of a mip chain and every entry of a palette
/// shares them, else Eq. 14 does not hold.
struct Grid {
  Six<int> bias{};
  Six<int> shift{};
  bool operator==(const Grid&) const = default;
};

/// Deltas (coef - bias) that may be stored, both ends included.
struct Window {
  int low = 0;
  int high = 0;
};

/// The largest stored value, 2^coef_bits - 1.
[[nodiscard]] int coef_top(const reference::EvalConfig& config);

/// Deltas that both a stored value and D1's delta_bits allow at this bias.
[[nodiscard]] Window delta_window(const reference::EvalConfig& config, int bias);

/// The coefficients that share a shift with coefficient i (itself alone if shift_groups = 6).
[[nodiscard]] std::span<const std::size_t> shift_group(const reference::EvalConfig& config,
                                                       std::size_t i);

/// Throws std::invalid_argument unless the sizes are positive, polynomials is 1 or 3, and `values`
/// is width * height * polynomials * 6.
void check_size(int width, int height, int polynomials, std::size_t values);

/// Throws std::invalid_argument naming the first coefficient that is not finite.
void check_finite(std::span<const double> coef);

/// Throws std::invalid_argument if the configuration cannot hold the grid.
void check_grid(const Grid& grid, const reference::EvalConfig& config);

/// What storing a set of values at one shift costs, for every bias, in squared units of the values.
struct BiasCosts {
  std::vector<double> error;       ///< [bias]
  std::vector<double> saturation;  ///< [bias], the part that comes from values outside the window
  int best = 0;                    ///< the bias of least error; of a run of equals, the middle one

  [[nodiscard]] double least() const { return error[static_cast<std::size_t>(best)]; }
};

/// The squared error of every bias at a given shift.
///
///     error(bias) = sum over values of (clamp(round(v 2^shift), window(bias)) 2^-shift - v)^2
///
/// Exact, by prefix sums over a histogram of the rounded values: O(values + 2^coef_bits).
[[nodiscard]] BiasCosts bias_costs(std::span<const double> values, int shift,
                                   const reference::EvalConfig& config);

}  // namespace ptm::quantize
