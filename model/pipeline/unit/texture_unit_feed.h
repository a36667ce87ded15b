#pragma once
#include "model/pipeline/unit/texture_unit.h"

namespace ptm::pipeline {

/// All fragments through the unit. For texture_unit.cpp and texture_unit_effects.cpp alone, an
/// instance each: so the way without effects is inlined as if there were no other.
template <bool kEffects>
TextureUnit::Feed TextureUnit::feed(std::span<const reference::UnitFragment> fragments) {
  Feed fed;
  Cycle next = 0;
  for (const reference::UnitFragment& fragment : fragments) {
    const Cycle taken = address_.accept<kEffects>(fragment, next + gap(timing_, fed.accepted));
    if (taken >= kStuck) break;
    if (fed.accepted++ == 0) fed.first = taken;
    fed.last = taken;
    next = taken + 1;
  }
  return fed;
}

}  // namespace ptm::pipeline
