#include "golden/render/light_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ptm::golden {
namespace {

Rgb clamp_to_levels(const Rgb& color) {
  Rgb clamped{};
  for (std::size_t c = 0; c < 3; ++c) clamped[c] = std::clamp(color[c], 0.0, 255.0);
  return clamped;
}

/// A polynomial's value where a square or a product is no double: with a long double's wider
/// exponents, and at most the largest double, which is beyond every level all the same.
double far_luminance(const Coefficients& a, double light_u, double light_v) {
  const long double u = light_u, v = light_v;
  const long double value =
      a[0] * (u * u) + a[1] * (v * v) + a[2] * (u * v) + a[3] * u + a[4] * v + a[5];
  constexpr long double most = std::numeric_limits<double>::max();
  return static_cast<double>(std::clamp(value, -most, most));
}

Rgb light_lrgb(const PtmMap& map, std::size_t texel, double u, double v) {
  const double l = luminance(real_coefficients(map, texel), u, v);
  Rgb color{};
  for (std::size_t c = 0; c < 3; ++c) color[c] = colored(map.color[texel * 3 + c], l);
  return color;
}

Rgb light_rgb(const PtmMap& map, std::size_t texel, double u, double v) {
  Rgb color{};
  for (std::size_t c = 0; c < 3; ++c) color[c] = luminance(real_coefficients(map, texel, c), u, v);
  return color;
}

Rgb light_lum(const PtmMap& map, std::size_t texel, double u, double v) {
  const double y = luminance(real_coefficients(map, texel), u, v);
  const double cr = map.color[texel * 2];
  const double cb = map.color[texel * 2 + 1];
  Rgb color{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double* row = &map.lum_matrix[c * 4];
    color[c] = row[0] * cr + row[1] * y + row[2] * cb + row[3];
  }
  return color;
}

}  // namespace

Coefficients real_coefficients(const PtmMap& map, std::size_t texel, std::size_t polynomial) {
  const std::uint8_t* coef = &map.coef[(texel * map.polynomials() + polynomial) * 6];
  Coefficients a{};
  for (std::size_t k = 0; k < 6; ++k) {
    a[k] = (static_cast<double>(coef[k]) - static_cast<double>(map.bias[k])) * map.scale[k];
  }
  return a;
}

double luminance(const Coefficients& a, double u, double v) {
  const double value =
      a[0] * (u * u) + a[1] * (v * v) + a[2] * (u * v) + a[3] * u + a[4] * v + a[5];
  return std::isfinite(value) ? value : far_luminance(a, u, v);
}

double colored(double color, double value) {
  const double product = color * value;
  return std::isfinite(product) ? product / 255 : color / 255 * value;
}

Rgb light_texel(const PtmMap& map, std::size_t texel, double u, double v) {
  switch (map.kind) {
    case MapKind::lrgb:
      return clamp_to_levels(light_lrgb(map, texel, u, v));
    case MapKind::rgb:
      return clamp_to_levels(light_rgb(map, texel, u, v));
    case MapKind::lum:
      break;
  }
  return clamp_to_levels(light_lum(map, texel, u, v));
}

ImageReal light_map(const PtmMap& map, double u, double v) {
  ImageReal image(map.width, map.height, 3);
  for (std::size_t texel = 0; texel < map.texels(); ++texel) {
    const Rgb color = light_texel(map, texel, u, v);
    std::copy(color.begin(), color.end(), &image.samples[texel * 3]);
  }
  return image;
}

Image8 to_8_bit(const ImageReal& image, Rounding8 rounding) {
  Image8 bytes(image.width, image.height, image.channels);
  const double half = rounding == Rounding8::nearest ? 0.5 : 0.0;
  std::transform(image.samples.begin(), image.samples.end(), bytes.samples.begin(), [&](double x) {
    if (std::isnan(x)) throw std::invalid_argument("a picture's sample that is no number");
    return static_cast<std::uint8_t>(std::floor(std::clamp(x + half, 0.0, 255.0)));
  });
  return bytes;
}

}  // namespace ptm::golden
