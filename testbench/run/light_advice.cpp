#include "testbench/run/light_advice.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace ptm::testbench {
namespace {

/// Three decimals, rounded toward 0 so that a point of the rim stays within the disc.
double three_decimals(double x) { return std::trunc(x * 1000) / 1000; }

std::string pair(double u, double v) {
  std::ostringstream text;
  // Adding 0 turns -0 into 0.
  text << three_decimals(u) + 0.0 << "," << three_decimals(v) + 0.0;
  return text.str();
}

}  // namespace

std::string light_advice(double u, double v) {
  // Scaled, so that squares of huge numbers stay finite.
  const double length = std::hypot(u, v);
  if (length <= 1) return {};
  const double most = std::max(std::abs(u), std::abs(v));
  const double radius = std::hypot(u / most, v / most);
  std::string text =
      "U and V are the first two coordinates of the unit vector toward the light, so U^2 + V^2 is "
      "at most 1; the nearest light on the horizon is " +
      pair(u / most / radius, v / most / radius);
  const bool degrees = most > 2 && std::abs(u) <= 360 && v >= 0 && v <= 90;
  if (degrees) {
    constexpr double radian = std::numbers::pi / 180;
    std::ostringstream angles;
    angles << "; azimuth " << u << " and elevation " << v << " in degrees are "
           << pair(std::cos(v * radian) * std::cos(u * radian),
                   std::cos(v * radian) * std::sin(u * radian));
    text += angles.str();
  }
  return text;
}

}  // namespace ptm::testbench
