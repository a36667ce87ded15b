// Pictures of a beach through a day while the tide goes out.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "golden/scene/image_stack.h"
#include "golden/scene/noise.h"

namespace ptm::golden {
namespace {

using Color = std::array<double, 3>;

constexpr double kHorizon = 0.34;

Color mix(const Color& a, const Color& b, double t) {
  Color out{};
  for (std::size_t c = 0; c < 3; ++c) out[c] = std::lerp(a[c], b[c], t);
  return out;
}

double step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Light of an hour, 0 dawn .. 1 dusk.
Color daylight(double hour) {
  const double high = std::sin(std::numbers::pi * (0.08 + 0.84 * hour));
  const Color dawn{0.75, 0.55, 0.55}, noon{1, 1, 0.97}, dusk{0.95, 0.55, 0.32};
  return mix(hour < 0.5 ? dawn : dusk, noon, step(0.2, 1, high));
}

Color sky(std::uint64_t seed, double u, double v, double hour) {
  const double high = std::sin(std::numbers::pi * (0.08 + 0.84 * hour));
  const Color low = mix(hour < 0.5 ? Color{0.9, 0.65, 0.6} : Color{1, 0.55, 0.25},
                        Color{0.8, 0.88, 0.95}, step(0.2, 1, high));
  const Color top = mix(Color{0.25, 0.25, 0.45}, Color{0.25, 0.5, 0.9}, step(0.2, 1, high));
  const double cloud = step(0.5, 0.75, fractal_noise(seed, 5 * u, 12 * v, 4));
  return mix(mix(top, low, v / kHorizon), daylight(hour), 0.6 * cloud);
}

Color sand(std::uint64_t seed, double u, double v) {
  const double depth = (v - kHorizon) / (1 - kHorizon);
  const double grain = fractal_noise(seed + 1, 40 * u, 60 * v, 3);
  Color color{0.8 - 0.15 * grain, 0.68 - 0.15 * grain, 0.48 - 0.12 * grain};
  // Stones that the water leaves behind.
  const double stone = fractal_noise(seed + 2, 9 * u, 18 * v, 2);
  if (stone > 0.66) color = mix(color, {0.28, 0.26, 0.25}, step(0.66, 0.7, stone));
  return mix(mix(color, {0.6, 0.6, 0.55}, 0.3), color, depth);
}

Color sea(std::uint64_t seed, double u, double v, double hour) {
  const double wave = fractal_noise(seed + 3, 8 * u, 60 * v, 3);
  return mix(Color{0.1, 0.3, 0.4}, sky(seed, u, 0.7 * kHorizon, hour), 0.25 + 0.4 * wave);
}

Color beach(std::uint64_t seed, double u, double v, double hour) {
  const Color light = daylight(hour);
  if (v < kHorizon) return sky(seed, u, v, hour);
  // The waterline falls, aslant and in bays.
  const double line =
      0.92 - 0.42 * hour - 0.12 * (u - 0.5) + 0.05 * (fractal_noise(seed + 4, 4 * u, 0.5, 2) - 0.5);
  const double dry = step(line - 0.01, line + 0.01, v);
  const double wet = 1 - step(line, line + 0.12, v);
  Color ground = mix(sand(seed, u, v), mix(sand(seed, u, v), {0.2, 0.17, 0.14}, 0.5), wet);
  for (std::size_t c = 0; c < 3; ++c) ground[c] *= light[c];
  const double foam = std::exp(-std::pow((v - line) / 0.012, 2));
  return mix(mix(sea(seed, u, v, hour), ground, dry), light, 0.7 * foam);
}

}  // namespace

std::vector<StackPicture> tide_pictures(const TextureSpec& spec) {
  const int width = spec.size[0], height = spec.size[1];
  std::vector<StackPicture> pictures(kTidePictures);
  tbb::parallel_for(0, kTidePictures, [&](int n) {
    StackPicture& picture = pictures[static_cast<std::size_t>(n)];
    const double hour = static_cast<double>(n) / (kTidePictures - 1);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const Color color = beach(spec.seed, (x + 0.5) / width, (y + 0.5) / height, hour);
        for (const double c : color) picture.push_back(255 * std::clamp(c, 0.0, 1.0));
      }
    }
  });
  return pictures;
}

}  // namespace ptm::golden
