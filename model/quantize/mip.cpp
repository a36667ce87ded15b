#include "model/quantize/mip.h"

#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "model/quantize/grid.h"

namespace ptm::quantize {
namespace {

struct Tap {
  std::size_t source = 0;
  double weight = 0;
};

/// Which of `side` samples a sample of the half covers, and by what share of it.
std::vector<std::vector<Tap>> cover(std::int64_t side) {
  const std::int64_t count = half_side(static_cast<int>(side));
  std::vector<std::vector<Tap>> taps(static_cast<std::size_t>(count));
  // In units of 1 / count of a source sample everything is an integer: sample s spans
  // [s count, (s + 1) count), target i spans [i side, (i + 1) side).
  for (std::int64_t i = 0; i < count; ++i) {
    for (std::int64_t s = i * side / count; s * count < (i + 1) * side; ++s) {
      const std::int64_t first = std::max(s * count, i * side);
      const std::int64_t last = std::min((s + 1) * count, (i + 1) * side);
      if (last > first) {
        taps[static_cast<std::size_t>(i)].push_back(
            {static_cast<std::size_t>(s),
             static_cast<double>(last - first) / static_cast<double>(side)});
      }
    }
  }
  return taps;
}

}  // namespace

std::vector<double> halve(std::span<const double> values, int width, int height, int channels) {
  if (width < 1 || height < 1 || channels < 1) {
    throw std::invalid_argument("a level of " + std::to_string(width) + " x " +
                                std::to_string(height) + " x " + std::to_string(channels));
  }
  const auto stride = static_cast<std::size_t>(channels);
  const std::size_t row = static_cast<std::size_t>(width) * stride;
  if (values.size() != row * static_cast<std::size_t>(height)) {
    throw std::invalid_argument("a level whose size does not agree with its samples");
  }
  const auto across = cover(width), down = cover(height);
  std::vector<double> half(across.size() * down.size() * stride);
  auto out = half.begin();
  for (const auto& rows : down) {
    for (const auto& columns : across) {
      for (const Tap& y : rows) {
        for (const Tap& x : columns) {
          const double* from = &values[y.source * row + x.source * stride];
          for (std::size_t c = 0; c < stride; ++c) {
            out[static_cast<std::ptrdiff_t>(c)] += y.weight * x.weight * from[c];
          }
        }
      }
      out += channels;
    }
  }
  return half;
}

std::vector<RealLevel> mip_levels(const RealMap& map) {
  check_size(map.width, map.height, map.polynomials, map.coef.size());
  std::vector<RealLevel> levels;
  RealMap above = map;
  while (above.width > 1 || above.height > 1) {
    levels.push_back({.width = half_side(above.width),
                      .height = half_side(above.height),
                      .polynomials = map.polynomials,
                      .coef = halve(above.coef, above.width, above.height,
                                    map.polynomials * static_cast<int>(kSix))});
    above = levels.back().view();
  }
  return levels;
}

}  // namespace ptm::quantize
