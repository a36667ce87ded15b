#include "golden/scene/tablet.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "golden/fit/light_solver.h"
#include "golden/scene/noise.h"

namespace ptm::golden {
namespace {

constexpr double kRows = 8, kColumns = 9;

/// How deep a wedge is, 0..1: a triangular head that tapers to a tail along +a. Lengths in cells.
double wedge(double a, double b) {
  constexpr double length = 0.8;
  if (a < 0 || a > length) return 0;
  const double along = a / length;
  const double half = 0.2 * (1 - along) * (1 - along) + 0.035;
  const double across = std::abs(b) / half;
  if (across >= 1) return 0;
  const double head = std::min(1.0, a / 0.08);
  return head * (1 - across) * (0.35 + 0.65 * (1 - along));
}

/// The wedges of one cell, in its own coordinates 0..1, y up.
double sign_depth(std::uint64_t seed, std::int64_t column, std::int64_t row, double x, double y) {
  double depth = 0;
  const int strokes = 2 + static_cast<int>(3 * hash_noise(seed, column, row, 1));
  for (int k = 0; k < strokes; ++k) {
    const auto at = [&](int z) { return hash_noise(seed, column, row, 10 * k + z + 2); };
    const double px = x - 0.1 - 0.5 * at(0), py = y - 0.9 + 0.5 * at(1);
    // Styluses leave wedges that lie or stand, few that lean.
    const double kind = at(2);
    const double angle = kind < 0.45 ? 0 : kind < 0.85 ? -0.5 : -0.25;
    const double c = std::cos(angle * std::numbers::pi), s = std::sin(angle * std::numbers::pi);
    depth = std::max(depth, wedge(px * c + py * s, -px * s + py * c));
  }
  return depth;
}

struct Clay {
  std::array<double, 3> color{};
  Vec3 normal{0, 0, 1};
};

Clay clay_at(std::uint64_t seed, double x, double y, double step) {
  const double dx = (tablet_height(seed, x + step, y) - tablet_height(seed, x - step, y));
  const double dy = (tablet_height(seed, x, y + step) - tablet_height(seed, x, y - step));
  const double stain = fractal_noise(seed + 7, 5 * x, 5 * y, 4);
  Clay clay;
  clay.normal = Vec3(-dx / (2 * step), -dy / (2 * step), 1).normalized();
  clay.color = {0.78 - 0.2 * stain, 0.62 - 0.2 * stain, 0.46 - 0.18 * stain};
  return clay;
}

std::vector<std::array<double, 3>> dome_lights() {
  std::vector<std::array<double, 3>> lights;
  const double low = std::sin(15 * std::numbers::pi / 180);
  const double high = std::sin(80 * std::numbers::pi / 180);
  for (int n = 0; n < kTabletLights; ++n) {
    const double w = low + (high - low) * (n + 0.5) / kTabletLights;
    const double angle = n * std::numbers::pi * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - w * w);
    lights.push_back({r * std::cos(angle), r * std::sin(angle), w});
  }
  return lights;
}

}  // namespace

double tablet_height(std::uint64_t seed, double x, double y) {
  const double edge = std::max(std::abs(x), std::abs(y));
  const double round = edge > 0.8 ? -1.2 * (edge - 0.8) * (edge - 0.8) : 0;
  const double worn = 0.03 * (fractal_noise(seed + 3, 4 * x, 4 * y, 3) - 0.5) +
                      0.004 * (fractal_noise(seed + 5, 40 * x, 40 * y, 2) - 0.5);
  double carved = 0;
  if (edge < 0.86) {
    const double cx = (x + 0.86) / 1.72 * kColumns, cy = (y + 0.86) / 1.72 * kRows;
    const double column = std::floor(cx), row = std::floor(cy);
    carved = 0.035 * sign_depth(seed, static_cast<std::int64_t>(column),
                                static_cast<std::int64_t>(row), cx - column, cy - row);
    if (cy - row < 0.03) carved = std::max(carved, 0.01);  // a ruled line
  }
  return round + worn - carved;
}

LoadedTexture make_tablet(const TextureSpec& spec) {
  LoadedTexture texture;
  texture.width = spec.size[0];
  texture.height = spec.size[1];
  texture.coef.resize(texture.texels() * 6);
  texture.color.resize(texture.texels() * 3);
  const auto lights = dome_lights();
  const LightSolver solver = solve_lights(lights);
  const double step = std::min(0.01, 1.0 / std::max(spec.size[0], spec.size[1]));
  tbb::parallel_for(0, texture.height, [&](int row) {
    Eigen::VectorXd photographs(kTabletLights);
    for (int column = 0; column < texture.width; ++column) {
      const double x = 2 * (column + 0.5) / texture.width - 1;
      const double y = 1 - 2 * (row + 0.5) / texture.height;
      const Clay clay = clay_at(spec.seed, x, y, step);
      for (int n = 0; n < kTabletLights; ++n) {
        const auto& [lu, lv, lw] = lights[static_cast<std::size_t>(n)];
        photographs[n] = 255 * (0.08 + 0.92 * std::max(0.0, clay.normal.dot(Vec3(lu, lv, lw))));
      }
      const Eigen::Matrix<double, 6, 1> a = solver.inverse * photographs;
      const auto t = static_cast<std::size_t>(row) * static_cast<std::size_t>(texture.width) +
                     static_cast<std::size_t>(column);
      for (std::size_t k = 0; k < 6; ++k) texture.coef[t * 6 + k] = a[static_cast<int>(k)];
      for (std::size_t c = 0; c < 3; ++c) {
        texture.color[t * 3 + c] = static_cast<std::uint8_t>(255 * clay.color[c] + 0.5);
      }
    }
  });
  return texture;
}

}  // namespace ptm::golden
