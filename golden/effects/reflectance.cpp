#include "golden/effects/reflectance.h"

#include <algorithm>
#include <cmath>

namespace ptm::golden {

double reflectance(double cosine, double n, double k) {
  const double c = std::clamp(cosine, 0.0, 1.0), c2 = c * c, s2 = 1 - c2;
  const double g2 = n * n - k * k - s2;
  const double p = std::hypot(g2, 2 * n * k);
  // Real part of the square root of (n + i k)^2 - s^2.
  const double a = std::sqrt(std::max(0.0, (p + g2) / 2));
  const double across = (p - 2 * a * c + c2) / (p + 2 * a * c + c2);
  const double below = c2 * p + 2 * a * c * s2 + s2 * s2;
  // 0 only where light meets no surface at all: n = 1, k = 0, at grazing.
  if (!(below > 0) || !(p + 2 * a * c + c2 > 0)) return 1;
  const double along = across * (c2 * p - 2 * a * c * s2 + s2 * s2) / below;
  return std::clamp((across + along) / 2, 0.0, 1.0);
}

}  // namespace ptm::golden
