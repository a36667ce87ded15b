#include "golden/fit/light_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "golden/files/figure_text.h"

namespace ptm::golden {
namespace {

constexpr std::size_t kSides = 8, kHeights = 45;  ///< directions looked at: azimuths, elevations
constexpr double kOutside = 1e-3;  ///< sine of the angle to the determined subspace, from rounding

constexpr double kUsualLimit = 15;  ///< degrees: few domes have lights below

}  // namespace

double prediction_variance(const LightSolver& solver, double u, double v) {
  const Eigen::Matrix<double, 6, 1> b = light_basis(u, v);
  const Eigen::VectorXd within = solver.subspace.transpose() * b;
  if ((b - solver.subspace * within).norm() > kOutside * b.norm()) {
    return std::numeric_limits<double>::infinity();
  }
  return within.cwiseQuotient(solver.singular_values.head(solver.rank)).squaredNorm();
}

LightCoverage cover_hemisphere(const LightSolver& solver) {
  static constexpr std::array<const char*, kSides> names{
      "the right", "the upper right", "the top",    "the upper left",
      "the left",  "the lower left",  "the bottom", "the lower right"};
  LightCoverage coverage;
  std::array<int, kSides> limits{};  ///< degrees below which a side is extrapolated
  std::size_t beyond = 0;
  for (std::size_t side = 0; side < kSides; ++side) {
    const double azimuth = 2 * std::numbers::pi * static_cast<double>(side) / kSides;
    double below = 0;
    for (std::size_t n = 0; n < kHeights; ++n) {
      // Equal steps of the elevation's sine are equal solid angles.
      const double w = (static_cast<double>(n) + 0.5) / kHeights, r = std::sqrt(1 - w * w);
      const double u = r * std::cos(azimuth), v = r * std::sin(azimuth);
      if (prediction_variance(solver, u, v) <= 1) continue;
      ++beyond;
      below = std::asin((static_cast<double>(n) + 1) / kHeights) * 180 / std::numbers::pi;
    }
    if (below > kUsualLimit) limits[side] = static_cast<int>(std::ceil(below));
  }
  const bool alike =
      std::all_of(limits.begin(), limits.end(), [&](int limit) { return limit == limits[0]; });
  for (std::size_t side = 0; side < kSides && limits != decltype(limits){}; ++side) {
    if (limits[side] == 0 || (alike && side > 0)) continue;
    coverage.directions += std::string(coverage.directions.empty() ? "from " : ", from ") +
                           (alike ? "all sides" : names[side]) + " below " +
                           count_of(limits[side], "degree");
  }
  coverage.extrapolated = static_cast<double>(beyond) / (kSides * kHeights);
  return coverage;
}

}  // namespace ptm::golden
