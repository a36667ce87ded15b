#include "golden/scene/effect_patterns.h"

#include <algorithm>
#include <cmath>

#include "golden/scene/noise.h"

namespace ptm::golden {

Stuff disc_at(std::uint64_t seed, double u, double v) {
  const double r = 2 * std::hypot(u - 0.5, v - 0.5);
  Stuff stuff;
  stuff.alpha = r < 0.97 ? 1 : 0;
  if (r >= 0.97) return stuff;
  const double ring = smooth_noise(seed, 60 * r, 0.5);
  double gray = 0.16 + 0.06 * ring;
  if (r < 0.14) gray = 0.06;
  if (r > 0.13 && r < 0.15) gray = 0.3;
  stuff.color = {gray, gray, 1.08 * gray};
  return stuff;
}

Stuff metal_at(std::uint64_t seed, double u, double v) {
  const double cloud = fractal_noise(seed, 12 * u, 8 * v, 3);
  Stuff stuff;
  const double gray = 0.07 + 0.05 * cloud;
  stuff.color = {gray, gray, gray};
  return stuff;
}

Stuff gloss_at(std::uint64_t seed, double u, double v) {
  constexpr double tiles = 6, joint = 0.06;
  const double x = tiles * u, y = tiles * v;
  const double in_x = x - std::floor(x), in_y = y - std::floor(y);
  Stuff stuff;
  stuff.steady = true;
  const double edge = std::min({in_x, in_y, 1 - in_x, 1 - in_y});
  double gloss = 0.05;
  if (edge > joint) {
    const double tile = hash_noise(seed, static_cast<std::int64_t>(std::floor(x)),
                                   static_cast<std::int64_t>(std::floor(y)));
    const double smear = fractal_noise(seed + 1, 20 * u + 6 * v, 5 * v, 3);
    gloss = std::clamp(0.35 + 0.65 * tile - std::max(0.0, 3 * (smear - 0.55)), 0.05, 1.0);
  }
  stuff.color = {gloss, gloss, gloss};
  return stuff;
}

}  // namespace ptm::golden
