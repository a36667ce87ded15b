#pragma once
#include <Eigen/Core>
#include <array>
#include <span>

namespace ptm::golden {

/// The polynomial's basis at a light: u^2, v^2, uv, u, v, 1     (Polynomial Texture Maps, Eq. 5)
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
  double condition = 0;      ///< largest singular value over the smallest not treated as zero
  Eigen::MatrixXd design;    ///< [light][coefficient]
  Eigen::MatrixXd subspace;  ///< [coefficient][rank], orthonormal: what the lights determine
  /// Diagonal of the hat matrix design * inverse: how much a light's own sample decides what the
  /// fit says there; 1 means alone. The leave-one-out residual of a light is r_i / (1 - h_i).
  Eigen::VectorXd leverage;
};

inline constexpr double kRankTolerance = 1e-6;

/// From this condition number on a fit is called ill-conditioned: an error of one level in the
/// photographs may then be one of hundreds in a coefficient.
inline constexpr double kIllConditioned = 1e3;

/// Directions are unit vectors, or (u, 0, 0) for maps of one parameter, which leaves rank 3 at most
/// and v's coefficients 0; at least one (std::invalid_argument otherwise).
[[nodiscard]] LightSolver solve_lights(std::span<const std::array<double, 3>> directions);

/// The same for rows of the basis, one a light; at least one.
[[nodiscard]] LightSolver solve_design(const Eigen::Matrix<double, Eigen::Dynamic, 6>& design);

}  // namespace ptm::golden
