#pragma once
#include <array>
#include <cstdint>

namespace ptm::golden {

/// What the demo's stone is at a point: x, y in [-1, 1], y up.
struct SlabPoint {
  double height = 0;               ///< half widths; the plain surface lies near 0
  std::array<double, 3> albedo{};  ///< red, green, blue in 0..1
  double gloss = 0;                ///< 0 dull .. 1 glazed
};

/// The slab's design: carving, weathering and paint in one place, so that paint follows carving.
[[nodiscard]] SlabPoint slab_at(std::uint64_t seed, double x, double y);

}  // namespace ptm::golden
