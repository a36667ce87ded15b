#pragma once
#include <Eigen/Core>
#include <array>
#include <span>

namespace ptm::golden {

/// The polynomial's basis at a light (u^2, v^2, uv, u, v, 1)        (Polynomial Texture Maps, Eq.
/// 5)
[[nodiscard]] Eigen::Matrix<double, 6, 1> light_basis(double u, double v);

/// Least squares for one arrangement of lights, solved once and applied to every pixel.
///
///     coefficients = inverse * samples           (Eq. 8; inverse = pseudo-inverse by SVD)
///
/// Singular values below `kRankTolerance` of the largest are treated as zero: fewer than six
/// lights, duplicates, all lights on a line or a ring still give the coefficients of minimum norm
/// among those that fit best, with `rank` below 6.
struct LightSolver {
  Eigen::Matrix<double, 6, Eigen::Dynamic> inverse;  ///< [coefficient][light]
  Eigen::VectorXd singular_values;                   ///< descending; min(6, lights) of them
  int rank = 0;
  double condition = 0;  ///< largest singular value over the smallest not treated as zero
};

inline constexpr double kRankTolerance = 1e-6;

/// Directions are unit vectors; at least one (std::invalid_argument otherwise).
[[nodiscard]] LightSolver solve_lights(std::span<const std::array<double, 3>> directions);

}  // namespace ptm::golden
