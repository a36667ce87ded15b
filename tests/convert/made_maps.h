#pragma once
#include <cmath>

#include "golden/files/ptm_map.h"

namespace ptm::tests {

/// A map like a photographed relief: slopes and a little deterministic noise, power-of-two scales
/// that preset `base` takes verbatim (lrgb and rgb).
inline golden::PtmMap smooth_map(golden::MapKind kind, int width, int height) {
  golden::PtmMap map;
  map.kind = kind;
  map.width = width;
  map.height = height;
  map.scale.fill(1);
  map.bias = {150, 150, 128, 128, 128, 0};
  std::uint32_t noise = 1;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (std::size_t k = 0; k < 6 * map.polynomials(); ++k) {
        noise = noise * 1664525U + 1013904223U;
        const double shape = std::array{100.0, 105.0, 125.0, 140.0, 120.0, 170.0}[k % 6];
        const double wave =
            25 * std::sin(0.11 * x + 0.3 * static_cast<double>(k)) * std::cos(0.09 * y);
        map.coef.push_back(static_cast<std::uint8_t>(shape + wave + (noise >> 24) % 7));
      }
      for (std::size_t c = 0; c < map.color_bytes(); ++c) {
        map.color.push_back(static_cast<std::uint8_t>(120 + 60 * std::sin(0.07 * (x + y)) +
                                                      20.0 * static_cast<double>(c)));
      }
    }
  }
  if (kind == golden::MapKind::lum) {
    map.lum_matrix = {1.402, 1, 0,     -179.456, -0.714, 1, -0.344, 135.4,
                      0,     1, 1.772, -226.8,   0,      0, 0,      1};
  }
  return map;
}

}  // namespace ptm::tests
