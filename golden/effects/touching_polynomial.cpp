#include "golden/effects/touching_polynomial.h"

#include <algorithm>

namespace ptm::golden {

Coefficients touching_polynomial(const std::array<double, 3>& normal) {
  const auto [u, v, w] = normal;
  const double steep = std::max(w, kSteepest), part = 1 / (steep * steep);
  const double uu = -(1 + u * u * part) / 2, vv = -(1 + v * v * part) / 2, uv = -u * v * part;
  return {uu,
          vv,
          uv,
          -(2 * uu * u + uv * v),
          -(2 * vv * v + uv * u),
          1 + uu * u * u + vv * v * v + uv * u * v};
}

}  // namespace ptm::golden
