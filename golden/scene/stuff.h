#pragma once
#include <array>

#include "golden/scene/shape.h"

namespace ptm::golden {

/// What a computed texture is at one texel. Normal: u right, v up, w to the viewer.
struct Stuff {
  Vec3 normal{0, 0, 1};
  std::array<double, 3> color{};  ///< 0..1
  double alpha = 1;
  bool steady = false;  ///< a map of it is as bright under every light
};

}  // namespace ptm::golden
