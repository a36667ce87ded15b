#include "golden/fit/hp_quantizer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ptm::golden {

void CoefficientRange::add(std::span<const double> coef) {
  for (std::size_t n = 0; n < coef.size(); ++n) {
    low[n % 6] = std::min(low[n % 6], coef[n]);
    high[n % 6] = std::max(high[n % 6], coef[n]);
  }
}

void CoefficientRange::add(const CoefficientRange& other) {
  for (std::size_t k = 0; k < 6; ++k) {
    low[k] = std::min(low[k], other.low[k]);
    high[k] = std::max(high[k], other.high[k]);
  }
}

HpGrid hp_grid(const CoefficientRange& range) {
  HpGrid grid;
  for (std::size_t k = 0; k < 6; ++k) {
    const double low = range.low[k], high = range.high[k];
    if (!std::isfinite(low) || !std::isfinite(high)) {
      throw std::invalid_argument("a range of coefficients that is not finite");
    }
    int exponent = 0;
    (void)std::frexp(high - low, &exponent);
    double scale = std::max(std::ldexp(1.0, exponent - 8), std::numeric_limits<double>::min());
    if (low < 0) {
      while (std::floor(-low / scale + 1) > 255) scale *= 2;
      grid.bias[k] = static_cast<std::int32_t>(std::floor(-low / scale + 1));
    } else {
      while (high / scale > 255) scale *= 2;
    }
    grid.scale[k] = scale;
  }
  return grid;
}

void hp_store(std::span<const double> coef, const HpGrid& grid, std::span<std::uint8_t> bytes,
              std::array<std::uint64_t, 6>& saturated) {
  if (bytes.size() != coef.size()) throw std::invalid_argument("bytes of another number");
  for (std::size_t n = 0; n < coef.size(); ++n) {
    const std::size_t k = n % 6;
    const double rounded = std::floor(coef[n] / grid.scale[k] + grid.bias[k] + 0.5);
    const double stored = std::clamp(rounded, 0.0, 255.0);
    saturated[k] += stored != rounded ? 1U : 0U;
    bytes[n] = static_cast<std::uint8_t>(stored);
  }
}

}  // namespace ptm::golden
