#pragma once
#include <array>
#include <cstdint>

#include "golden/files/image.h"

namespace ptm::testbench {

using Rgb8 = std::array<std::uint8_t, 3>;

/// The colour of t in 0..1 (limited to it): nearly black, violet, red, orange, pale yellow, ordered
/// by lightness so that it reads as well in grey.
[[nodiscard]] Rgb8 heat_color(double t);

/// Where and how much b differs from a: a pixel's colour is heat_color(error / full_scale), error
/// the largest |b - a| of its channels in levels. full_scale <= 0 gives a map of no differences.
/// With `block` > 1 a pixel of the map stands for block x block pixels and shows the largest of
/// their errors: a single wrong pixel is not averaged away.
/// Throws std::invalid_argument unless the sizes agree and block >= 1.
[[nodiscard]] golden::Image8 heat_map(const golden::ImageReal& a, const golden::ImageReal& b,
                                      double full_scale, int block = 1);

}  // namespace ptm::testbench
