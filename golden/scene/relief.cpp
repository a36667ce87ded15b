#include "golden/scene/relief.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "golden/scene/noise.h"
#include "golden/scene/slab.h"

namespace ptm::golden {
namespace {

constexpr double kExposure = 262;      ///< level of a white surface lit from straight above
constexpr double kGlossExponent = 28;  ///< of the half-way vector, Blinn
constexpr double kGlossStrength = 0.32;
constexpr double kStray = 0.035;       ///< light from the room's walls, as a share of the lamp's
constexpr double kLampRadius = 0.017;  ///< tangent of one degree

template <class Body>
void for_rows(int rows, const Body& body) {
  tbb::parallel_for(0, rows, body);
}

std::uint8_t level(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::floor(value + 0.5), 0.0, 255.0));
}

}  // namespace

Relief::Relief(const ReliefOptions& options) : options_(options) {
  const int n = options.size;
  if (n < 16 || n > 4096) {
    throw std::invalid_argument("a relief of " + std::to_string(n) +
                                " pixels, expected 16 to 4096");
  }
  height_ = ImageReal(n, n, 1);
  normal_ = ImageReal(n, n, 3);
  albedo_ = ImageReal(n, n, 4);
  const double pixel = 2.0 / n;
  for_rows(n, [&](int row) {
    for (int column = 0; column < n; ++column) {
      const SlabPoint p =
          slab_at(options.seed, (column + 0.5) * pixel - 1, 1 - (row + 0.5) * pixel);
      height_.at(column, row) = p.height;
      for (int c = 0; c < 3; ++c) {
        albedo_.at(column, row, c) = p.albedo[static_cast<std::size_t>(c)];
      }
      albedo_.at(column, row, 3) = p.gloss;
    }
  });
  highest_ = *std::max_element(height_.samples.begin(), height_.samples.end());
  for_rows(n, [&](int row) {
    for (int column = 0; column < n; ++column) {
      const double dx = (height_at(column + 1, row) - height_at(column - 1, row)) / (2 * pixel);
      const double dy = (height_at(column, row - 1) - height_at(column, row + 1)) / (2 * pixel);
      const double length = std::sqrt(dx * dx + dy * dy + 1);
      normal_.at(column, row, 0) = -dx / length;
      normal_.at(column, row, 1) = -dy / length;
      normal_.at(column, row, 2) = 1 / length;
    }
  });
}

double Relief::height_at(double column, double row) const {
  const double last = options_.size - 1;
  const double x = std::clamp(column, 0.0, last), y = std::clamp(row, 0.0, last);
  const int x0 = std::min(static_cast<int>(x), options_.size - 2);
  const int y0 = std::min(static_cast<int>(y), options_.size - 2);
  const double fx = x - x0, fy = y - y0;
  const double top = height_.at(x0, y0) * (1 - fx) + height_.at(x0 + 1, y0) * fx;
  const double bottom = height_.at(x0, y0 + 1) * (1 - fx) + height_.at(x0 + 1, y0 + 1) * fx;
  return top * (1 - fy) + bottom * fy;
}

/// Marches towards the light, a pixel a step. The ray's clearance over the surface, as a share of
/// the lamp's width seen from there, tells how much of the lamp is visible.
double Relief::lit_share(int x, int y, const std::array<double, 3>& light) const {
  const double horizontal = std::hypot(light[0], light[1]);
  if (horizontal < 1e-9) return 1;
  const double pixel = 2.0 / options_.size;
  const double rise = light[2] / horizontal * pixel;  // height gained a step
  const double start = height_.at(x, y);
  double share = 1;
  for (int step = 1; share > 0; ++step) {
    const double ray = start + rise * step;
    const double column = x + step * light[0] / horizontal;
    const double row = y - step * light[1] / horizontal;
    const bool outside =
        column < 0 || row < 0 || column > options_.size - 1 || row > options_.size - 1;
    const double lamp = kLampRadius * pixel * step / light[2];
    if (outside || ray - lamp > highest_) break;
    const double clearance = ray - height_at(column, row);
    share = std::min(share, 0.5 + 0.5 * clearance / lamp);
  }
  return std::clamp(share, 0.0, 1.0);
}

Image8 Relief::photograph(const std::array<double, 3>& light) const {
  const int n = options_.size;
  Image8 picture(n, n, 3);
  const double half = std::sqrt(2 + 2 * light[2]);  // length of light + view
  const std::array<double, 3> middle{light[0] / half, light[1] / half, (light[2] + 1) / half};
  // Each photograph has its own sensor noise.
  const auto exposure = static_cast<std::int64_t>(std::llround((light[0] * 7 + light[1]) * 1e6));
  for_rows(n, [&](int row) {
    for (int column = 0; column < n; ++column) {
      const double* normal = &normal_.at(column, row);
      const double* albedo = &albedo_.at(column, row);
      const double lambert = normal[0] * light[0] + normal[1] * light[1] + normal[2] * light[2];
      const double towards = normal[0] * middle[0] + normal[1] * middle[1] + normal[2] * middle[2];
      const double lit = lambert > 0 ? lit_share(column, row, light) : 0.0;
      const double gloss = albedo[3] * kGlossStrength *
                           std::pow(std::max(towards, 0.0), kGlossExponent) *
                           std::min(1.0, 8 * std::max(lambert, 0.0));
      for (int c = 0; c < 3; ++c) {
        const double noise = hash_noise(options_.seed + 999, column * 3 + c, row, exposure) +
                             hash_noise(options_.seed + 998, column * 3 + c, row, exposure) - 1;
        const double diffuse = albedo[c] * (kStray * normal[2] + lit * std::max(lambert, 0.0));
        const double value = kExposure * (diffuse + lit * gloss);
        picture.at(column, row, c) = level(value + 1.2 * noise);
      }
    }
  });
  return picture;
}

std::vector<std::array<double, 3>> spread_lights(int count) {
  if (count < 1) throw std::invalid_argument("a capture needs at least one light");
  // Equal steps of z are equal solid angles; the golden angle keeps neighbours apart.
  const double lowest = std::sin(10 * std::numbers::pi / 180);
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<std::array<double, 3>> lights;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (1 - lowest) * (i + 0.5) / count, radius = std::sqrt(1 - z * z);
    lights.push_back({radius * std::cos(golden * i), radius * std::sin(golden * i), z});
  }
  return lights;
}

}  // namespace ptm::golden
