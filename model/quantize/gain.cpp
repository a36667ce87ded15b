#include "model/quantize/gain.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/quantize/maps.h"

namespace ptm::quantize {
namespace {

using Polynomial = Eigen::Matrix<double, 6, 1>;

void check_texels(std::size_t coefficients, std::size_t bytes) {
  if (coefficients % kSix != 0 || coefficients / kSix * 3 != bytes) {
    throw std::invalid_argument("coefficients and colours of different numbers of texels");
  }
}

}  // namespace

std::vector<double> equalize_strength(std::span<double> coef, std::span<const std::uint8_t> color,
                                      const Gram& gram) {
  check_texels(coef.size(), color.size());
  std::vector<double> norms;
  double most = 0;
  for (std::size_t t = 0; t * kSix < coef.size(); ++t) {
    const Eigen::Map<const Polynomial> a(&coef[t * kSix]);
    norms.push_back(std::sqrt(std::max(0.0, a.dot(gram * a))));
    const auto rgb = color.subspan(t * 3, 3);
    most = std::max(most, norms.back() * *std::max_element(rgb.begin(), rgb.end()) / 255);
  }
  for (std::size_t t = 0; t < norms.size(); ++t) {
    double& factor = norms[t];
    factor = factor > 0 && most > 0 ? factor / most : 1;
    for (double& a : coef.subspan(t * kSix, kSix)) a /= factor;
  }
  return norms;
}

std::vector<double> color_weights(std::span<const std::uint8_t> color,
                                  std::span<const double> factors) {
  std::vector<double> weights(factors.size());
  for (std::size_t t = 0; t < weights.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      weights[t] += std::pow(factors[t] * color[t * 3 + c] / 255, 2) / 3;
    }
  }
  const bool black = std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0; });
  return black ? std::vector<double>{} : weights;
}

std::vector<std::uint8_t> refit_colors(std::span<const double> real, std::span<const double> stored,
                                       std::span<const std::uint8_t> color, const Gram& gram) {
  check_texels(real.size(), color.size());
  check_texels(stored.size(), color.size());
  std::vector<std::uint8_t> refit(color.begin(), color.end());
  for (std::size_t t = 0; t * kSix < real.size(); ++t) {
    const Eigen::Map<const Polynomial> a(&real[t * kSix]), p(&stored[t * kSix]);
    const Polynomial weighed = gram * p;
    const double square = p.dot(weighed);
    if (!(square > 0)) continue;
    const double factor = a.dot(weighed) / square;
    for (std::size_t c = 0; c < 3; ++c) {
      const double level = std::clamp(color[t * 3 + c] * factor, 0.0, 255.0);
      refit[t * 3 + c] = static_cast<std::uint8_t>(std::floor(level + 0.5));
    }
  }
  return refit;
}

}  // namespace ptm::quantize
