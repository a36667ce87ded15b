#include "golden/effects/map_normals.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "golden/files/figure_text.h"
#include "golden/geometry/direction.h"

namespace ptm::golden {
namespace {

constexpr double kDegenerate = 1e-12;

/// Eq. 5 along the rim, and its slope in the angle.
double on_rim(const Coefficients& a, double angle) {
  return luminance(a, std::cos(angle), std::sin(angle));
}
double slope_on_rim(const Coefficients& a, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return 2 * (a[1] - a[0]) * c * s + a[2] * (c * c - s * s) - a[3] * s + a[4] * c;
}

/// Two harmonics have at most two maxima; 64 angles part them, and between an angle's neighbours
/// the slope falls through 0 once.
Peak rim_peak(const Coefficients& a, double scale) {
  constexpr int angles = 64;
  constexpr double step = 2 * std::numbers::pi / angles;
  double best = on_rim(a, 0), least = best, angle = 0;
  for (int n = 1; n < angles; ++n) {
    const double value = on_rim(a, n * step);
    least = std::min(least, value);
    if (value > best + kDegenerate * scale) {
      best = value;
      angle = n * step;
    }
  }
  if (best - least <= kDegenerate * scale) return {{0, 0}, PeakKind::flat};
  double low = angle - step, high = angle + step;
  for (int n = 0; n < 40; ++n) {
    const double middle = (low + high) / 2;
    (slope_on_rim(a, middle) > 0 ? low : high) = middle;
  }
  return {{std::cos(low), std::sin(low)}, PeakKind::rim};
}

/// A line of maxima: the curvature is negative across it and 0 along it, and so is the slope along.
bool ridge_peak(const Coefficients& a, double scale, Peak& peak) {
  const double bend = a[0] + a[1];  // the one eigenvalue that is not 0
  if (!(bend < 0)) return false;
  // The eigenvector's outer product is the curvature over its eigenvalue.
  const double xx = a[0] / bend, yy = a[1] / bend, xy = a[2] / 2 / bend;
  const double along_u = a[3] - (xx * a[3] + xy * a[4]);
  const double along_v = a[4] - (xy * a[3] + yy * a[4]);
  if (std::hypot(along_u, along_v) > 1e-9 * scale) return false;
  peak = {{-a[3] / (2 * bend), -a[4] / (2 * bend)}, PeakKind::ridge};
  return std::hypot(peak.light[0], peak.light[1]) <= 1;
}

}  // namespace

Peak brightest_light(const Coefficients& a) {
  double scale = 0;
  for (std::size_t k = 0; k < 5; ++k) scale = std::max(scale, std::abs(a[k]));
  if (scale == 0) return {};
  // The maximum's place is that of every multiple; products of far smaller or larger numbers than
  // maps have would leave the doubles.
  if (scale > 1e100 || scale < 1e-100) {
    Coefficients near_one{};
    for (std::size_t k = 0; k < 5; ++k) near_one[k] = std::ldexp(a[k], -std::ilogb(scale));
    return brightest_light(near_one);
  }
  const double determinant = 4 * a[0] * a[1] - a[2] * a[2];
  const double curvature = std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
  if (determinant > kDegenerate * curvature * curvature) {
    if (a[0] < 0) {
      const double u = (a[2] * a[4] - 2 * a[1] * a[3]) / determinant;
      const double v = (a[2] * a[3] - 2 * a[0] * a[4]) / determinant;
      if (std::hypot(u, v) < 1) return {{u, v}, PeakKind::inside};
    }
  } else if (determinant >= -kDegenerate * curvature * curvature) {
    Peak peak;
    if (ridge_peak(a, scale, peak)) return peak;
  }
  return rim_peak(a, scale);
}

Coefficients luma_polynomial(const LoadedTexture& map, std::size_t texel) {
  constexpr std::array<double, 3> weights{0.299, 0.587, 0.114};
  Coefficients a{};
  if (map.polynomials == 1) {
    std::copy_n(&map.coef[texel * 6], 6, a.begin());
    return a;
  }
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t k = 0; k < 6; ++k) a[k] += weights[c] * map.coef[(texel * 3 + c) * 6 + k];
  }
  return a;
}

std::array<double, 3> normal_of(const Coefficients& a, const Peak& peak) {
  if (peak.kind == PeakKind::inside || peak.kind == PeakKind::ridge) {
    const auto [u, v] = peak.light;
    return {u, v, std::sqrt(std::max(0.0, 1 - u * u - v * v))};
  }
  const Eigen::Vector3d whole(a[3], a[4], std::max(0.0, a[5]));
  if (whole.isZero(0)) return {0, 0, 1};
  const Eigen::Vector3d normal = unit(whole);
  return {normal[0], normal[1], normal[2]};
}

MapNormals map_normals(const LoadedTexture& map) {
  MapNormals out;
  out.field.width = map.width;
  out.field.height = map.height;
  out.field.normals.resize(map.texels());
  std::atomic<std::size_t> without = 0;
  tbb::parallel_for(std::size_t{0}, static_cast<std::size_t>(map.height), [&](std::size_t row) {
    const std::size_t width = static_cast<std::size_t>(map.width);
    std::size_t count = 0;
    for (std::size_t t = row * width; t < (row + 1) * width; ++t) {
      const Coefficients a = luma_polynomial(map, t);
      const Peak peak = brightest_light(a);
      out.field.normals[t] = normal_of(a, peak);
      count += peak.kind != PeakKind::inside;
    }
    without += count;
  });
  out.without_maximum = without;
  return out;
}

std::string without_maximum_note(const LoadedTexture& map, std::size_t count) {
  return std::to_string(count) + " of " + count_of(map.texels(), "texel") + " of '" + map.name +
         (count == 1 ? "' has" : "' have") + " no maximum within the disc of lights";
}

}  // namespace ptm::golden
