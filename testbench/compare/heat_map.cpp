#include "testbench/compare/heat_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace ptm::testbench {
namespace {

// Evenly spaced from 0 to 1, made in OKLCh (Ottosson 2020): lightness 0.12 + 0.85 t, hue from 265
// to 460 degrees, chroma 92 % of what sRGB holds there, at most 0.21.
constexpr std::array<Rgb8, 17> kColors = {{{2, 5, 17},
                                           {11, 3, 57},
                                           {31, 5, 78},
                                           {54, 8, 95},
                                           {81, 12, 107},
                                           {109, 16, 113},
                                           {138, 21, 115},
                                           {168, 26, 111},
                                           {197, 32, 102},
                                           {224, 48, 87},
                                           {245, 73, 66},
                                           {248, 113, 67},
                                           {249, 146, 80},
                                           {250, 175, 102},
                                           {251, 201, 127},
                                           {253, 225, 158},
                                           {254, 247, 201}}};

double pixel_error(const golden::ImageReal& a, const golden::ImageReal& b, int x, int y) {
  double error = 0;
  for (int c = 0; c < a.channels; ++c) {
    error = std::max(error, std::abs(b.at(x, y, c) - a.at(x, y, c)));
  }
  return error;
}

double block_error(const golden::ImageReal& a, const golden::ImageReal& b, int column, int row,
                   int block) {
  double error = 0;
  for (int y = row * block; y < std::min(a.height, (row + 1) * block); ++y) {
    for (int x = column * block; x < std::min(a.width, (column + 1) * block); ++x) {
      error = std::max(error, pixel_error(a, b, x, y));
    }
  }
  return error;
}

}  // namespace

Rgb8 heat_color(double t) {
  const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(kColors.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), kColors.size() - 2);
  const double part = place - static_cast<double>(below);
  Rgb8 color{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double low = kColors[below][c], high = kColors[below + 1][c];
    color[c] = static_cast<std::uint8_t>(low + (high - low) * part + 0.5);
  }
  return color;
}

golden::Image8 heat_map(const golden::ImageReal& a, const golden::ImageReal& b, double full_scale,
                        int block) {
  const bool same = a.width == b.width && a.height == b.height && a.channels == b.channels;
  if (!same || block < 1) throw std::invalid_argument("heat_map: sizes differ, or block < 1");
  golden::Image8 map((a.width + block - 1) / block, (a.height + block - 1) / block, 3);
  const double scale = full_scale > 0 ? 1 / full_scale : 0;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const Rgb8 color = heat_color(block_error(a, b, x, y, block) * scale);
      std::copy(color.begin(), color.end(), &map.at(x, y));
    }
  }
  return map;
}

}  // namespace ptm::testbench
