#pragma once
#include <cstdint>
#include <vector>

#include "model/reference/unit/unit_config.h"
#include "model/reference/unit/unit_fragment.h"
#include "model/reference/unit/unit_memory.h"

namespace ptm::tests {

/// A map drawn texel for texel, in rows.
struct UnitPlane {
  reference::UnitConfig config;
  std::vector<reference::Draw> draws;
  std::vector<reference::UnitFragment> fragments;
  std::vector<reference::Line> lines;

  /// Of `side` texels and pixels.
  explicit UnitPlane(int side) {
    reference::Draw draw;
    draw.map = {.width = side, .height = side};
    draws.push_back(draw);
    lines.resize(static_cast<std::size_t>(side * side) / 16 * 3);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        reference::UnitFragment f;
        f.x = static_cast<std::uint16_t>(x);
        f.y = static_cast<std::uint16_t>(y);
        f.u = (2 * x + 1) * (1 << 19) / side + 99;
        f.v = (2 * y + 1) * (1 << 19) / side + 99;
        fragments.push_back(f);
      }
    }
  }
};

}  // namespace ptm::tests
