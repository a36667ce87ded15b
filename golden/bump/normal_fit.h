#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace ptm::golden {

/// Over which (lu, lv) the polynomial of a normal is fitted.
enum class BumpDomain : std::uint8_t {
  disc,   ///< lu^2 + lv^2 <= 1, where there are lights
  square  ///< [-1, 1]^2 as the paper has it, the root taken as 0 in the corners
};

/// The matrix that gives the polynomial nearest to a normal's dot product with the light.
///
///     F(lu, lv) = lu Nu + lv Nv + sqrt(max(0, 1 - lu^2 - lv^2)) Nw            (Eq. 9)
///     a         = argmin of the integral of (L - F)^2 over the domain          (Eq. 10)
///               = [6][3] matrix * (Nu, Nv, Nw), a0 first, 1 for full light
///
/// Source    Polynomial Texture Maps, section 3.5, Eq. 9-13. Eq. 13 numbers its terms in the order
///           of Eq. 11's basis (1, u, v, uv, u^2, v^2); here they are in Eq. 5's. Eq. 10 integrates
///           a root that is not real in the corners of the square: there it counts as 0. Solved by
///           the normal equations of the basis, which is what projecting on an orthonormal one
///           does.
/// Result    Nu and Nv become a3 and a4 exactly; the root becomes p + q (lu^2 + lv^2) with
///           disc p = 16/15, q = -4/5; square p = pi/3, q = -pi/4 (both checked by a test).
/// Error     at the rim, where the root is 0: disc 4/15, square 0.262; see docs/design/bump.md.
[[nodiscard]] Eigen::Matrix<double, 6, 3> normal_fit(BumpDomain domain);

}  // namespace ptm::golden
