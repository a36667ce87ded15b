#include "golden/scene/slab.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "golden/scene/noise.h"

namespace ptm::golden {
namespace {

constexpr double kPi = std::numbers::pi;
using Color = std::array<double, 3>;

double step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// 1 on a line, 0 at `width` from it, round like a bead.
double ridge(double distance, double width) {
  const double t = std::abs(distance) / width;
  return t < 1 ? std::sqrt(1 - t * t) : 0.0;
}

Color mix(const Color& a, const Color& b, double t) {
  return {std::lerp(a[0], b[0], t), std::lerp(a[1], b[1], t), std::lerp(a[2], b[2], t)};
}

struct Stroke {
  double x0, y0, x1, y1;
};

/// P, T and M in a box of 1 x 1 each, straight strokes as a chisel makes them.
constexpr std::array<Stroke, 11> kLetters{{{0.15, 0, 0.15, 1},
                                           {0.15, 1, 0.6, 1},
                                           {0.6, 1, 0.75, 0.78},
                                           {0.75, 0.78, 0.6, 0.5},
                                           {0.6, 0.5, 0.15, 0.5},
                                           {1.4, 1, 2.2, 1},
                                           {1.8, 1, 1.8, 0},
                                           {2.8, 0, 2.9, 1},
                                           {2.9, 1, 3.3, 0.3},
                                           {3.3, 0.3, 3.7, 1},
                                           {3.7, 1, 3.8, 0}}};

double distance_to(const Stroke& s, double x, double y) {
  const double dx = s.x1 - s.x0, dy = s.y1 - s.y0;
  const double t = std::clamp(((x - s.x0) * dx + (y - s.y0) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(x - s.x0 - t * dx, y - s.y0 - t * dy);
}

double distance_to_letters(double x, double y) {
  constexpr double kSize = 0.155, kLeft = -0.305, kBase = -0.872;
  double nearest = 10;
  for (const Stroke& s : kLetters) {
    nearest = std::min(nearest, distance_to(s, (x - kLeft) / kSize, (y - kBase) / kSize));
  }
  return nearest * kSize;
}

/// A carved element: how high it stands, and how much of the point it covers with which paint.
struct Carving {
  double height = 0;
  double paint = 0;
  Color color{};
  double gloss = 0;
};

/// Two whorls of petals around a boss, all inside radius 0.46.
Carving rosette(double r, double angle) {
  Carving c;
  const auto whorl = [&](double turn, double inner, double outer, double lift, Color color) {
    const double sector = std::remainder(angle + turn, kPi / 4);
    const double along = (r - inner) / (outer - inner);
    if (along <= 0 || along >= 1) return;
    const double half = 0.36 * std::pow(std::sin(kPi * std::pow(along, 0.7)), 0.8);
    const double across = std::abs(sector) / std::max(half, 1e-6);
    if (across >= 1) return;
    // A dished petal with a raised rim and a groove along its middle.
    const double body = std::sqrt(1 - across * across);
    const double vein = 0.012 * step(0.16, 0.0, across) * std::sin(kPi * along);
    const double height = lift * (0.45 + 0.55 * along) * std::min(1.0, 2.2 * body) - vein -
                          0.03 * (1 - across * across) * std::sin(kPi * along);
    if (height > c.height) c = {height, step(1.0, 0.85, across), color, 0.35};
  };
  whorl(kPi / 8, 0.10, 0.46, 0.075, {0.16, 0.36, 0.62});
  whorl(0, 0.08, 0.36, 0.115, {0.74, 0.22, 0.16});
  const double boss = 0.14 * ridge(r, 0.12);
  if (boss > c.height) c = {boss, step(0.12, 0.11, r), {0.93, 0.72, 0.26}, 0.9};
  return c;
}

/// The medallion's border: a rope between two rings of beads and fillets.
Carving border(double r, double angle) {
  const double rope = ridge(r - 0.575, 0.05) * (0.05 + 0.028 * std::sin(36 * angle + 46 * r));
  const double spacing = 2 * kPi / 44;
  const double along = std::remainder(angle, spacing) * 0.675;
  const double beads = 0.062 * ridge(std::hypot(along, r - 0.675), 0.04);
  const double fillet = 0.035 * std::max(ridge(r - 0.505, 0.016), ridge(r - 0.735, 0.018));
  Carving c{fillet, 0.0, {}, 0.1};
  if (rope > c.height) c = {rope, 0.75, {0.62, 0.52, 0.30}, 0.25};
  if (beads > c.height) c = {beads, 0.9, {0.86, 0.66, 0.27}, 0.8};
  return c;
}

/// Spirals in the four corners, as grooves (negative height).
double corner_spirals(double x, double y) {
  const double cx = std::abs(x) - 0.74, cy = std::abs(y) - 0.74;
  const double r = std::hypot(cx, cy);
  if (r > 0.16) return 0;
  // Mirror images: the turn runs the other way on the left and at the bottom.
  const double turn = std::atan2(cy, cx) / (2 * kPi);
  const double pitch = 0.052;
  const double off = std::remainder(r - pitch * turn, pitch);
  return -0.030 * ridge(off, 0.017) * step(0.16, 0.13, r) * step(0.0, 0.02, r);
}

double frame(double x, double y) {
  const double edge = std::max(std::abs(x), std::abs(y));
  return 0.055 * step(0.91, 0.95, edge) - 0.03 * ridge(edge - 0.90, 0.012);
}

/// Sandstone: warm grains, darker veins.
Color stone(std::uint64_t seed, double x, double y) {
  const double cloud = fractal_noise(seed + 100, 3 * x, 3 * y, 4);
  const double warp = fractal_noise(seed + 200, 2 * x, 2 * y, 3);
  const double vein = std::exp(-60 * std::pow(std::sin(4 * (x + 0.6 * y) + 5 * warp), 2));
  const double grain = smooth_noise(seed + 300, 90 * x, 90 * y);
  Color c = mix({0.64, 0.53, 0.40}, {0.83, 0.75, 0.62}, cloud);
  c = mix(c, {0.45, 0.30, 0.22}, 0.55 * vein);
  for (double& v : c) v *= 0.90 + 0.16 * grain;
  return c;
}

}  // namespace

SlabPoint slab_at(std::uint64_t seed, double x, double y) {
  // The medallion sits a little high, to leave room for the letters.
  const double r = std::hypot(x, y - 0.07), angle = std::atan2(y - 0.07, x);
  const Carving middle = r < 0.48 ? rosette(r, angle) : border(r, angle);
  const double letters = distance_to_letters(x, y);
  const double groove = -0.045 * std::max(0.0, 1 - letters / 0.026);
  const double bowl = r < 0.50 ? -0.05 * step(0.50, 0.44, r) : 0.0;
  const double wear = fractal_noise(seed, 6 * x, 6 * y, 6);
  const double chips = step(0.62, 0.72, fractal_noise(seed + 50, 9 * x, 9 * y, 4));

  SlabPoint p;
  p.height = 0.62 * (bowl + middle.height + corner_spirals(x, y) + frame(x, y) + groove) +
             0.014 * (wear - 0.5) - 0.007 * chips;
  // Paint has gone where the stone is worn or chipped; dirt stays in what is carved deep.
  const double kept = middle.paint * step(0.72, 0.55, wear) * (1 - 0.8 * chips);
  p.albedo = mix(stone(seed, x, y), middle.color, 0.85 * kept);
  const double depth = step(0.0, -0.035, p.height);
  p.albedo = mix(p.albedo, {0.20, 0.27, 0.22}, 0.45 * depth);
  if (groove < 0) p.albedo = mix(p.albedo, {0.36, 0.10, 0.08}, 0.7 * step(0.026, 0.018, letters));
  p.gloss = middle.gloss * kept;
  return p;
}

}  // namespace ptm::golden
