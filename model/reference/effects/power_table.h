#pragma once
#include <cstddef>

#include "model/reference/unit/unit_memory.h"

namespace ptm::reference {

inline constexpr std::size_t kPowerTop = 4080;  ///< of an entry: 255 levels with 4 fraction bits

/// The table that X2 raises to a power with; software writes it.
///
///     table[i] = floor(4080 (i / 255)^exponent + 1/2)
///
/// Source    docs/spec/effects.md, X2; Eq. 8 and 15 of Polynomial Texture Maps
/// Requires  1 <= exponent <= 255; throws std::invalid_argument otherwise, also for NaN
/// Error     half a unit of 1/16 level an entry; it rises with i, from 0 to 4,080
[[nodiscard]] EffectTable effect_table(double exponent);

}  // namespace ptm::reference
