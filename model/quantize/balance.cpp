#include "model/quantize/balance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "model/quantize/gram.h"
#include "model/quantize/grid.h"

namespace ptm::quantize {
namespace {

using Polynomial = Eigen::Map<Eigen::Matrix<double, 6, 1>>;

/// The factor by which a texel's colour may grow, as near to `wanted` as its brightest channel
/// allows; 1 if there is no room or nothing to see.
double room_in_color(std::span<const std::uint8_t> color, double wanted) {
  const int brightest = *std::max_element(color.begin(), color.end());
  if (brightest == 0 || brightest == 255) return 1;
  return std::min(255.0, std::ceil(brightest * wanted)) / brightest;
}

/// No light within `reach` of the centre has a luminance above this: of l^T Q l + s l + a5 the
/// largest eigenvalue of Q, where it is positive, and the length of s.
double highest_luminance(const double* a, double reach) {
  const double mean = (a[0] + a[1]) / 2;
  const double curve = mean + std::hypot((a[0] - a[1]) / 2, a[2] / 2);
  return reach * (reach * std::max(0.0, curve) + std::hypot(a[3], a[4])) + a[5];
}

}  // namespace

Balance balance_luminance(std::span<double> coef, std::span<std::uint8_t> color,
                          std::span<const std::array<double, 2>> lights,
                          const reference::EvalConfig& config) {
  reference::validate(config);
  if (lights.empty()) throw std::invalid_argument("no lights to balance luminance for");
  if (coef.size() % kSix != 0 || coef.size() / kSix * 3 != color.size()) {
    throw std::invalid_argument("coefficients and colours of different numbers of texels");
  }
  check_finite(coef);
  Eigen::Matrix<double, Eigen::Dynamic, 6> bases(static_cast<Eigen::Index>(lights.size()), 6);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    bases.row(static_cast<Eigen::Index>(i)) = basis(lights[i][0], lights[i][1]).transpose();
  }
  double reach = 0;
  for (const auto& [lu, lv] : lights) reach = std::max(reach, std::hypot(lu, lv));
  const double unit = std::ldexp(1.0, -config.lum_frac);
  const double top = std::ldexp(1.0, config.lum_bits) - unit;
  Balance balance;
  for (std::size_t texel = 0; texel * kSix < coef.size(); ++texel) {
    // Most texels are far below the top, and that is told without trying every light.
    if (highest_luminance(&coef[texel * kSix], reach) < top * (1 - 1e-9)) continue;
    Polynomial a(&coef[texel * kSix]);
    const double most = (bases * a).maxCoeff();
    if (!(most > top)) continue;
    ++balance.exceeding;
    const auto rgb = color.subspan(texel * 3, 3);
    const double k = room_in_color(rgb, most / top);
    if (k > 1) {
      ++balance.scaled;
      a /= k;
      for (std::uint8_t& c : rgb) c = static_cast<std::uint8_t>(std::floor(c * k + 0.5));
    }
    if (most / k > top) ++balance.remaining;
  }
  return balance;
}

}  // namespace ptm::quantize
