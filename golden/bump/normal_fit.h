#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace ptm::golden {

/// Over which (lu, lv) the polynomial of a normal is fitted.
enum class BumpDomain : std::uint8_t {
  hemisphere,  ///< directions of light, each solid angle the same: dlu dlv / sqrt(1 - lu^2 - lv^2)
  disc,        ///< lu^2 + lv^2 <= 1, dlu dlv
  square       ///< [-1, 1]^2 as the paper has it, the root taken as 0 in the corners
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
/// Result    Nu and Nv become a3 and a4 exactly; the root becomes p + q (lu^2 + lv^2), checked by a
///           test:          p        q        at the rim   RMS over the hemisphere
///             hemisphere   9/8      -15/16   0.188        0.072
///             disc         16/15    -4/5     0.267        0.089
///             square       pi/3     -pi/4    0.262        0.088
///           Which to take: docs/design/bump.md.
[[nodiscard]] Eigen::Matrix<double, 6, 3> normal_fit(BumpDomain domain);

}  // namespace ptm::golden
