#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "model/reference/unit/draw.h"

namespace ptm::reference {

/// What the unit is asked at one pixel; fields and formats in docs/spec/unit.md, "Fragment".
struct UnitFragment {
  std::int32_t u = 0, v = 0;            ///< Q8.20
  std::int32_t axis_u = 0, axis_v = 0;  ///< Q8.20, from one probe to the next
  std::int32_t lu = 0, lv = 0;          ///< light codes
  std::int32_t hu = 0, hv = 0;          ///< the half-vector's; 0 where no effect asks for it
  std::uint16_t x = 0, y = 0;           ///< the pixel
  std::uint16_t lod = 0;                ///< Q4.8
  std::uint8_t probes_log2 = 0;
  std::uint8_t draw = 0;
  bool lit = true;
  bool operator==(const UnitFragment&) const = default;
};

/// The same in plain doubles, as geometry yields it.
struct PlainUnitSample {
  int x = 0, y = 0;
  double u = 0, v = 0;            ///< 1.0 is the texture's width or height; v runs down
  double lod = 0;                 ///< log2 of texels of level 0 a step; negative when magnified
  double axis_u = 0, axis_v = 0;  ///< from one probe to the next
  int probes_log2 = 0;
  double lu = 0, lv = 0;
  double hu = 0, hv = 0;  ///< of the half-vector; 0 where no effect asks for it
  bool lit = true;
  int draw = 0;
};

/// The one function from plain doubles to a fragment, docs/spec/unit.md, "Fragment". Nothing if a
/// number is not finite, light or half-vector has no code (light_code.h), or x, y, probes_log2 or
/// draw lies outside its format. Wrap modes are the draw's.
/// Error     half a unit of 2^-20 on u, v and the axis, half of 2^-8 on lod, where not limited
[[nodiscard]] std::optional<UnitFragment> quantize_unit_fragment(const EvalConfig& config,
                                                                 const Draw& draw,
                                                                 const PlainUnitSample& sample);

/// What the unit gives for one fragment.
struct UnitPixel {
  std::uint16_t x = 0, y = 0;
  std::array<std::uint8_t, 3> rgb{};
  std::uint8_t alpha = 255;
  bool lum_saturated = false, color_saturated = false;
  bool memory_failed = false;  ///< a line that it was made of could not be read
  bool operator==(const UnitPixel&) const = default;
};

}  // namespace ptm::reference
