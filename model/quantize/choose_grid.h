#pragma once
#include <cstdint>
#include <list>
#include <span>
#include <vector>

#include "model/quantize/grid.h"

/// Which shift and bias store a coefficient best. Chosen by error, not by range alone, and so that
/// a few outlying texels do not cost all others a bit.
namespace ptm::quantize {

/// What is to be stored of one coefficient: its value in every polynomial.
class Population {
 public:
  /// A value is an outlier beyond a sixteenth of the spread outside the central part that leaves
  /// out 1/4096 of the values at either end (at least one from 1,024 values on). `typical` are the
  /// values with outliers moved to that limit.
  Population(std::vector<double> values, double weight);

  [[nodiscard]] std::span<const double> all() const { return all_; }
  [[nodiscard]] std::span<const double> typical() const {
    return typical_.empty() ? all_ : typical_;
  }
  [[nodiscard]] bool has_outliers() const { return !typical_.empty(); }
  [[nodiscard]] double weight() const { return weight_; }  ///< of its squared error

  /// bias_costs() of all or of the typical values, kept for the next who asks: searches for shift
  /// and bias meet the same shifts. Not for several threads at once.
  enum class Part : std::uint8_t { all, typical };
  [[nodiscard]] const BiasCosts& costs(Part part, int shift,
                                       const reference::EvalConfig& config) const;

 private:
  struct Known {
    Part part;
    int shift;
    reference::EvalConfig config;
    BiasCosts costs;
  };
  std::vector<double> all_, typical_;
  double weight_;
  mutable std::list<Known> known_;
};

/// The shift that stores coefficients sharing one with the least weighted squared error, each with
/// its own best bias.
///
/// The choice by all values stands, unless the typical ones would have less than half the error
/// with their own choice: then outliers saturate. A finer grid contains the coarser one, so
/// each search starts at the finest shift at which nothing saturates and goes on to finer ones
/// until saturation alone costs more than the best so far. Values that are all zero get shift 0:
/// nothing is to be seen finer.
[[nodiscard]] int best_shift(std::span<const Population> coefficients,
                             const reference::EvalConfig& config);

/// The bias of least squared error at that shift, by the same rule about outliers.
[[nodiscard]] int best_bias(const Population& coefficient, int shift,
                            const reference::EvalConfig& config);

/// The grid by range alone: for each coefficient (each group that shares a shift) the finest shift
/// at which every value fits, and the bias that puts the values' range in the middle of the stored
/// range. What a plain quantiser does, and what others are measured against.
///
/// Values too large for any shift get the coarsest one. Sizes as check_size() wants them, finite
/// coefficients; std::invalid_argument otherwise.
[[nodiscard]] Grid range_grid(const RealMap& real, const reference::EvalConfig& config);

}  // namespace ptm::quantize
