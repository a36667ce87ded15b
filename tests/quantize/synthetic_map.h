#pragma once
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "model/quantize/quantize.h"

namespace ptm::tests {

/// Real coefficients like those of a fitted relief: smooth over the map, a little noise, the six
/// coupled as a lit surface couples them.
inline std::vector<double> synthetic_coefficients(int width, int height, std::uint32_t seed,
                                                  int polynomials = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 2.0);
  std::vector<double> coef;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int p = 0; p < polynomials; ++p) {
        const double nx = 0.5 * std::sin(0.13 * x + 0.4 * p), ny = 0.5 * std::cos(0.11 * y);
        const double nz = std::sqrt(1 - nx * nx - ny * ny);
        const double gain = 230 + 10 * std::sin(0.05 * (x + y));
        for (const double shape : {-0.45 * nz, -0.5 * nz, -0.2 * nx * ny, nx, ny, 0.95 * nz}) {
          coef.push_back(gain * shape + noise(random));
        }
      }
    }
  }
  return coef;
}

inline quantize::RealMap view(const std::vector<double>& coef, int width, int height,
                              int polynomials = 1) {
  return {.width = width, .height = height, .polynomials = polynomials, .coef = coef};
}

}  // namespace ptm::tests
