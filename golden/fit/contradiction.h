#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "golden/fit/photo_bands.h"

namespace ptm::golden {

/// Luminance of some texels in every photograph, and the basis at their lights.
struct ContradictionSample {
  std::size_t fitted = 0;               ///< the first so many photographs were fitted
  std::vector<Eigen::VectorXd> levels;  ///< one a texel, [photograph]
  /// [photograph][coefficient], one for all texels or one a texel.
  std::vector<Eigen::Matrix<double, Eigen::Dynamic, 6>> designs;
};

struct Contradictions {
  /// RMS of the photograph's residuals in levels, as far as those are known that agree; one a
  /// photograph, none where no other light speaks for it.
  std::vector<std::optional<double>> figures;
  std::vector<bool> contradicts;
};

/// Finds the photographs that contradict the others.
///
/// A photograph's figure is the RMS of its residuals r against a plain fit of a set of photographs,
/// each over its standard deviation in units of one sample's: sqrt(1 - h) if the photograph is in
/// the set, h its leverage, or else sqrt(1 + h), h = b . (A^T A)^+ b. Were all photographs alike
/// good, these figures would be alike. x is the figure's logarithm, half a level at least, since
/// photographs are rounded.
///
/// One bad photograph spoils the residuals of all, and two hide each other. So one after another
/// the fitted photograph of the largest figure is taken out, for at most a quarter of them and
/// while three more than the rank remain, and compared with the rest: with M the median of their x
/// and s = 1.4826 median |x - M|, it fails if x > M + k s and x > M + log 2. Of as many normal
/// numbers the largest exceeds k once in a hundred times; the factor of two is left to what shadows
/// and highlights differ beyond the trend. Up to the last that fails, all that were taken out
/// contradict (Rosner's generalised test of many outliers, Technometrics 25, 1983, with median and
/// deviation for mean and variance). Photographs that were not fitted are compared with the rest
/// then left.
[[nodiscard]] Contradictions find_contradictions(const ContradictionSample& sample);

}  // namespace ptm::golden
