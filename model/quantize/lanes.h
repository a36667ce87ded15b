#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/quantize/grid.h"
#include "model/quantize/maps.h"

/// Coefficients kept apart, one array ("lane") for each of the six, so that loops run over texels
/// and a machine with vectors takes several at a time. Every operation is one of real numbers in a
/// stated order, none fused: the results do not depend on the machine.
namespace ptm::quantize {

struct Lanes {
  Six<std::vector<double>> real;          ///< what is to be stored
  Six<std::vector<double>> error;         ///< stored less real, within +-1e100: squares stay finite
  Six<std::vector<std::int32_t>> stored;  ///< integers, bias included
  std::vector<double> luminance;          ///< squared change, mean over the lights
  std::vector<double> others;             ///< room for add_luminance()

  explicit Lanes(std::size_t polynomials);
  [[nodiscard]] std::size_t size() const { return luminance.size(); }
};

/// How one coefficient is rounded.
struct Step {
  int shift = 0;
  int bias = 0;
  Window window;
};

/// coef [polynomial][6] to the lanes' real values; luminance becomes 0.
void split(std::span<const double> coef, Lanes& lanes);

/// values[t] -= share * error[t]
void subtract_share(double share, std::span<const double> error, std::span<double> values);

/// For coefficient i and every polynomial
///
///     delta  = clamp(floor(target 2^shift + 1/2), window)
///     stored = delta + bias,   error = delta 2^-shift - real
///
/// Returns how many deltas the window clamped.
[[nodiscard]] std::uint64_t round_lane(std::span<const double> targets, const Step& step,
                                       std::size_t i, Lanes& lanes);

/// luminance[t] += (sum over j >= i of row[j] error_j[t])^2, row the i-th of the Gram's factor.
void add_luminance(const Six<double>& row, std::size_t i, Lanes& lanes);

/// The lanes' integers to [polynomial][6].
void merge(const Lanes& lanes, std::span<std::uint16_t> stored);

}  // namespace ptm::quantize
