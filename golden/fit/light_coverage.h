#pragma once
#include <string>

#include "golden/fit/light_solver.h"

namespace ptm::golden {

/// How much of the hemisphere of lights a fit extrapolates.
///
/// With b the basis at a direction, h = b . (A^T A)^+ b is the variance of what the fit says there,
/// in parts of the variance of one photograph's sample (the photographs' own h, the leverage, is at
/// most 1). Where h > 1, or where b leaves the subspace that the lights determine, the map says
/// less than one photograph would: it shows what the polynomial happens to do.
struct LightCoverage {
  double extrapolated = 0;  ///< such directions' share of the hemisphere, by solid angle
  std::string directions;  ///< where they are: "from the left below 50 degrees", sides of more than
                           ///< 15 degrees
};
/// h at a direction; infinite where b leaves the subspace that the lights determine.
[[nodiscard]] double prediction_variance(const LightSolver& solver, double u, double v);

[[nodiscard]] LightCoverage cover_hemisphere(const LightSolver& solver);

/// From this share on a note is due: all below 15 degrees, where few domes have lights, is 0.26.
inline constexpr double kNarrowCoverage = 0.3;

}  // namespace ptm::golden
