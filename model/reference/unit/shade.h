#pragma once
#include <array>
#include <span>

#include "model/reference/unit/beats.h"
#include "model/reference/unit/combine.h"
#include "model/reference/unit/filter.h"
#include "model/reference/unit/texel_fields.h"
#include "model/reference/unit/unit_memory.h"

/// Steps U7 to U11, X1 to X4 (docs/spec/effects.md) and the whole of a fragment.
namespace ptm::reference {

/// Every value on the way, for the report's worst-pixel table and for tests.
struct ShadeTrace {
  Fields filtered{};                 ///< after U9; fields that the draw has not are 0
  std::array<Six<Value>, 3> coef{};  ///< operands of each pass, after U10
  Three<Value> lit{};                ///< P
  std::array<Value, 4> color{};      ///< C and its alpha, 8 bits
  /// Of the extra passes, lum_frac fraction bits; 0 for those that the draw has not.
  std::array<Value, kExtraPasses> value{};
  Three<Value> addend{};  ///< behind the last stage, levels with 4 fraction bits
  UnitPixel pixel;
};

/// The pixel of one fragment. Requires a valid configuration, a legal draw (check_draw) that is
/// among the state's, and palettes that hold what its texels index.
[[nodiscard]] UnitPixel shade(const EvalConfig& config, const UnitState& state,
                              const UnitFragment& fragment);
[[nodiscard]] ShadeTrace shade_trace(const EvalConfig& config, const UnitState& state,
                                     const UnitFragment& fragment);

/// shade() for many fragments.
void shade_all(const EvalConfig& config, const UnitState& state,
               std::span<const UnitFragment> fragments, std::span<UnitPixel> pixels);

}  // namespace ptm::reference
