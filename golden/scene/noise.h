#pragma once
#include <cmath>
#include <cstdint>

/// Repeatable noise without tables or state.
namespace ptm::golden {

/// A number in [0, 1) that depends on all arguments and looks random (splitmix64's mixer).
[[nodiscard]] inline double hash_noise(std::uint64_t seed, std::int64_t x, std::int64_t y,
                                       std::int64_t z = 0) {
  std::uint64_t h = seed;
  for (const std::int64_t v : {x, y, z}) {
    h += static_cast<std::uint64_t>(v) + 0x9E3779B97F4A7C15U;
    h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9U;
    h = (h ^ (h >> 27)) * 0x94D049BB133111EBU;
    h ^= h >> 31;
  }
  return static_cast<double>(h >> 11) * 0x1p-53;
}

/// Smooth noise in [0, 1] with one knot a unit of length.
[[nodiscard]] inline double smooth_noise(std::uint64_t seed, double x, double y) {
  const double fx = std::floor(x), fy = std::floor(y);
  const auto ix = static_cast<std::int64_t>(fx), iy = static_cast<std::int64_t>(fy);
  const auto ease = [](double t) { return t * t * t * (t * (6 * t - 15) + 10); };
  const double u = ease(x - fx), v = ease(y - fy);
  const double low = std::lerp(hash_noise(seed, ix, iy), hash_noise(seed, ix + 1, iy), u);
  const double high = std::lerp(hash_noise(seed, ix, iy + 1), hash_noise(seed, ix + 1, iy + 1), u);
  return std::lerp(low, high, v);
}

/// Octaves of smooth noise, each of twice the frequency and half the strength; in [0, 1].
[[nodiscard]] inline double fractal_noise(std::uint64_t seed, double x, double y, int octaves) {
  double sum = 0, weight = 0.5, total = 0;
  for (int k = 0; k < octaves; ++k) {
    sum += weight * smooth_noise(seed + static_cast<std::uint64_t>(k), x, y);
    total += weight;
    weight /= 2;
    x = 2 * x + 17.3;
    y = 2 * y - 9.1;
  }
  return sum / total;
}

}  // namespace ptm::golden
