#pragma once
#include <algorithm>
#include <random>
#include <vector>

#include "golden/fit/photo_bands.h"
#include "golden/scene/relief.h"

namespace ptm::tests {

/// Photographs in memory, one row of texels, as the fit takes them.
struct MadePhotographs {
  std::vector<std::array<double, 3>> directions;
  std::size_t texels = 0;
  std::vector<float> samples;  ///< [light][channel][texel]

  MadePhotographs(std::size_t lights, std::size_t count)
      : directions(golden::spread_lights(static_cast<int>(lights))),
        texels(count),
        samples(lights * 3 * count) {}
  [[nodiscard]] float& at(std::size_t light, std::size_t channel, std::size_t texel) {
    return samples[(light * 3 + channel) * texels + texel];
  }
  [[nodiscard]] golden::PhotoTile tile() const { return {texels, texels, samples.data()}; }
  /// The same photographs without one.
  [[nodiscard]] MadePhotographs without(std::size_t light) const {
    MadePhotographs others = *this;
    others.directions.erase(others.directions.begin() + static_cast<std::ptrdiff_t>(light));
    const auto first = others.samples.begin() + static_cast<std::ptrdiff_t>(light * 3 * texels);
    others.samples.erase(first, first + static_cast<std::ptrdiff_t>(3 * texels));
    return others;
  }
  /// Each photograph rgb * L / 255, L the texel's polynomial.
  void light(const std::vector<Eigen::Matrix<double, 6, 1>>& polynomials,
             const std::array<double, 3>& rgb) {
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const auto basis = golden::light_basis(directions[i][0], directions[i][1]);
      for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t t = 0; t < texels; ++t) {
          at(i, c, t) = static_cast<float>(rgb[c] * basis.dot(polynomials[t]) / 255);
        }
      }
    }
  }
  void noise() {
    std::mt19937 random(9);
    std::uniform_real_distribution<float> level(0, 255);
    for (float& sample : samples) sample = level(random);
  }
};

/// Lit texels that never go dark: L between about 60 and 255, the largest sample exactly 255.
inline std::vector<Eigen::Matrix<double, 6, 1>> bright_polynomials(const MadePhotographs& lit) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> slope(-60, 60);
  std::vector<Eigen::Matrix<double, 6, 1>> polynomials(lit.texels);
  for (auto& a : polynomials) {
    a << slope(random) / 2, slope(random) / 2, slope(random) / 2, slope(random), slope(random), 190;
    double most = 0;
    for (const auto& d : lit.directions) {
      most = std::max(most, golden::light_basis(d[0], d[1]).dot(a));
    }
    a *= 255 / most;
  }
  return polynomials;
}

}  // namespace ptm::tests
