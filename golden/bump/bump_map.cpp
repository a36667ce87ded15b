#include "golden/bump/bump_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "golden/geometry/direction.h"
#include "golden/render/light_map.h"

namespace ptm::golden {
namespace {

std::array<double, 3> unit_normal(double u, double v, double w) {
  const Eigen::Vector3d normal = unit({u, v, w});
  return {normal[0], normal[1], normal[2]};
}

void check(const ImageReal& picture, double strength) {
  if (picture.width < 1 || picture.height < 1 || picture.channels < 1) {
    throw std::invalid_argument("a bump map without pixels");
  }
  if (!std::isfinite(strength)) throw std::invalid_argument("a strength that is not finite");
}

/// Mean of a pixel's channels, 0..1.
double height_at(const ImageReal& picture, int x, int y) {
  double sum = 0;
  for (int c = 0; c < picture.channels; ++c) sum += picture.at(x, y, c);
  return sum / picture.channels / 255;
}

/// The samples before and after one, as far as the picture has them.
struct Neighbours {
  int before = 0, after = 0;
  [[nodiscard]] double apart() const { return std::max(1, after - before); }
};
Neighbours neighbours(int at, int side) {
  return {std::max(0, at - 1), std::min(side - 1, at + 1)};
}

/// Direction n of count, spread evenly by solid angle from the horizon up: equal steps of height,
/// turned by the golden angle.
std::array<double, 3> direction(std::size_t n, std::size_t count) {
  const double w = (static_cast<double>(n) + 0.5) / static_cast<double>(count);
  const double angle = static_cast<double>(n) * std::numbers::pi * (3 - std::sqrt(5.0));
  const double r = std::sqrt(1 - w * w);
  return {r * std::cos(angle), r * std::sin(angle), w};
}

}  // namespace

NormalField normals_from_heights(const ImageReal& picture, double strength) {
  check(picture, strength);
  NormalField field{.width = picture.width, .height = picture.height, .normals = {}};
  for (int y = 0; y < picture.height; ++y) {
    const Neighbours rows = neighbours(y, picture.height);
    for (int x = 0; x < picture.width; ++x) {
      const Neighbours columns = neighbours(x, picture.width);
      const double across =
          (height_at(picture, columns.after, y) - height_at(picture, columns.before, y)) /
          columns.apart();
      const double down =
          (height_at(picture, x, rows.after) - height_at(picture, x, rows.before)) / rows.apart();
      field.normals.push_back(unit_normal(-strength * across, strength * down, 1));
    }
  }
  return field;
}

std::vector<double> bump_coefficients(const NormalField& field, const NormalTable& table) {
  std::vector<double> coef;
  coef.reserve(field.normals.size() * 6);
  for (const auto& normal : field.normals) {
    for (const double a : table.find(normal)) coef.push_back(255 * a);
  }
  return coef;
}

BumpError measure_bump(const NormalField& field, const std::vector<double>& coef,
                       std::size_t lights) {
  if (field.normals.empty() || coef.size() != field.normals.size() * 6 || lights == 0) {
    throw std::invalid_argument("coefficients and normals of different sizes");
  }
  const std::size_t step = (field.normals.size() + 4095) / 4096;
  BumpError error;
  std::array<double, 9> squares{}, counts{};
  for (std::size_t t = 0; t < field.normals.size(); t += step) {
    Coefficients a{};
    std::copy_n(&coef[t * 6], 6, a.begin());
    const auto& normal = field.normals[t];
    for (std::size_t n = 0; n < lights; ++n) {
      const auto light = direction(n, lights);
      const double dot = normal[0] * light[0] + normal[1] * light[1] + normal[2] * light[2];
      const double off = std::max(0.0, luminance(a, light[0], light[1])) - 255 * std::max(0.0, dot);
      const double elevation = std::asin(light[2]) * 180 / std::numbers::pi;
      const auto band = std::min<std::size_t>(8, static_cast<std::size_t>(elevation / 10));
      squares[band] += off * off;
      counts[band] += 1;
      error.max = std::max(error.max, std::abs(off));
    }
  }
  double all = 0, count = 0;
  for (std::size_t band = 0; band < 9; ++band) {
    all += squares[band];
    count += counts[band];
    if (counts[band] > 0) error.by_elevation[band] = std::sqrt(squares[band] / counts[band]);
  }
  error.rmse = std::sqrt(all / count);
  return error;
}

}  // namespace ptm::golden
