#pragma once
#include <cstdint>
#include <optional>

#include "contract/registers.h"
#include "model/reference/eval_config.h"
#include "model/reference/integer.h"

namespace ptm::reference {

inline constexpr int kCoordinateFrac = 20;  ///< texture coordinates are Q8.20 with a sign
using contract::kLargestSide;

/// What the unit is asked at one pixel; docs/spec/pipeline.md, Coordinates, has its formats.
struct Fragment {
  std::int32_t x = 0, y = 0;  ///< the pixel, carried along
  Value u = 0, v = 0;         ///< Q8.20: 1.0 is the texture's width or height
  Value lu = 0, lv = 0;       ///< light codes
};

/// A sample in plain doubles, as geometry yields it.
struct PlainSample {
  double u = 0, v = 0, lu = 0, lv = 0;
};

/// The one function from plain doubles to a fragment: coordinates rounded to Q8.20, light to its
/// code. Nothing if a light coordinate has no code (light_code.h) or a coordinate no Q8.20.
[[nodiscard]] std::optional<Fragment> quantize_fragment(const EvalConfig& config, std::int32_t x,
                                                        std::int32_t y, const PlainSample& sample);

/// Point sampling: (u * size) >> 20, for u in [0, 1).
[[nodiscard]] constexpr Value nearest_index(Value u, int size) {
  return shift_right(u * Value{size}, kCoordinateFrac);
}

}  // namespace ptm::reference
