#include "testbench/run/map_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/reference/error_bound.h"

namespace ptm::testbench {
namespace {

/// The polynomial is nowhere on the unit disc above this: the linear part's peak and the quadratic
/// one's, which need not be in one place.
double most_luminance(const std::array<double, 6>& a) {
  const double middle = (a[0] + a[1]) / 2, spread = std::hypot((a[0] - a[1]) / 2, a[2] / 2);
  return a[5] + std::hypot(a[3], a[4]) + std::max(middle + spread, 0.0);
}

}  // namespace

std::vector<double> texel_error_bounds(const golden::PtmMap& map, const quantize::StoredMap& stored,
                                       const reference::EvalConfig& config) {
  const bool lrgb = map.kind == golden::MapKind::lrgb;
  const auto polynomials = static_cast<std::size_t>(stored.polynomials);
  const double top = std::ldexp(1.0, config.lum_bits) - std::ldexp(1.0, -config.lum_frac);
  std::vector<double> bounds(map.texels());
  for (std::size_t t = 0; t < bounds.size(); ++t) {
    for (std::size_t p = 0; p < polynomials; ++p) {
      std::array<double, 6> a{};
      for (std::size_t i = 0; i < 6; ++i) {
        const int delta = stored.coef[(t * polynomials + p) * 6 + i] - stored.bias[i];
        a[i] = std::ldexp(delta, -stored.shift[i]);
      }
      if (most_luminance(a) > top) bounds[t] = std::numeric_limits<double>::infinity();
      const reference::ErrorBound bound = reference::error_bound(config, a, stored.shift);
      const auto color = map.color.begin() + static_cast<std::ptrdiff_t>(lrgb ? 3 * t : 0);
      bounds[t] =
          std::max(bounds[t], lrgb ? bound.of_lrgb_channel(*std::max_element(color, color + 3))
                                   : bound.of_rgb_channel());
    }
  }
  return bounds;
}

}  // namespace ptm::testbench
