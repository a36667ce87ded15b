#pragma once
#include <array>
#include <span>

#include "model/reference/unit/beats.h"
#include "model/reference/unit/unit_memory.h"

/// Steps U7 to U11 and the whole of a fragment.
namespace ptm::reference {

inline constexpr unsigned kFields = 26;
/// A filtered fragment: 0..17 coefficients, 18..20 the map's R G B, 21 its A, 22..25 the colour
/// texture's R G B A.
using Fields = std::array<Value, kFields>;

/// Every value on the way, for the report's worst-pixel table and for tests.
struct ShadeTrace {
  Fields filtered{};                 ///< after U9
  std::array<Six<Value>, 3> coef{};  ///< operands of each pass, after U10
  Three<Value> lit{};                ///< P
  std::array<Value, 4> color{};      ///< C and its alpha, 8 bits
  UnitPixel pixel;
};

/// U11, one channel.
[[nodiscard]] Value combine_channel(const EvalConfig& config, Combine combine, Value lit,
                                    Value color, Value color_alpha, Value ka, Value kd);

/// The pixel of one fragment. Requires a legal draw (check_draw), fragment.draw among the state's.
[[nodiscard]] UnitPixel shade(const EvalConfig& config, const UnitState& state,
                              const UnitFragment& fragment);
[[nodiscard]] ShadeTrace shade_trace(const EvalConfig& config, const UnitState& state,
                                     const UnitFragment& fragment);

/// shade() for many fragments.
void shade_all(const EvalConfig& config, const UnitState& state,
               std::span<const UnitFragment> fragments, std::span<UnitPixel> pixels);

}  // namespace ptm::reference
