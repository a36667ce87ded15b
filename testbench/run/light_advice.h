#pragma once
#include <string>

namespace ptm::testbench {

/// What a light outside of the unit disc may have been meant to be, one sentence; empty for a light
/// within it. A light is the first two coordinates of a unit vector, so u^2 + v^2 is at most 1:
/// named are the nearest point of the disc's rim, and what the numbers stand for if they are
/// degrees:
///
///     u = cos(elevation) cos(azimuth),  v = cos(elevation) sin(azimuth)
///
/// Requires finite u and v.
[[nodiscard]] std::string light_advice(double u, double v);

}  // namespace ptm::testbench
