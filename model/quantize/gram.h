#pragma once
#include <Eigen/Core>
#include <array>
#include <span>

namespace ptm::quantize {

/// Second moments of the basis b = (lu^2, lv^2, lu lv, lu, lv, 1) over the lights of interest:
///
///     G = mean of b b^T,   mean over lights of (L' - L)^2 = (a' - a)^T G (a' - a)
///
/// so that a quantiser can weigh errors of coefficients by what they do to the luminance.
using Gram = Eigen::Matrix<double, 6, 6>;

/// The basis at a light, in order of the coefficients (Polynomial Texture Maps, Eq. 5).
[[nodiscard]] Eigen::Matrix<double, 6, 1> basis(double lu, double lv);

/// G for lights spread evenly over the hemisphere by solid angle, in closed form:
/// E[x^2] = 1/3, E[x^4] = 1/5, E[x^2 y^2] = 1/15, every odd moment 0.
[[nodiscard]] Gram hemisphere_gram();

/// G for a list of lights (lu, lv), each of the same weight. An empty list or a coordinate that is
/// not finite throws std::invalid_argument.
[[nodiscard]] Gram gram_of_lights(std::span<const std::array<double, 2>> lights);

/// Upper triangular R with R^T R = G.
///
/// Lights that leave a polynomial undetermined (fewer than six, all on a line or a ring) make G
/// singular; then 1e-3 of the hemisphere's G, scaled to the same trace, is added first, so that
/// what the lights leave open is settled by lights from elsewhere. "Singular" is a ratio of
/// eigenvalues below 1e-9. A G that is not symmetric, not finite or has a negative eigenvalue
/// beyond rounding throws std::invalid_argument.
[[nodiscard]] Gram gram_factor(const Gram& gram);

}  // namespace ptm::quantize
