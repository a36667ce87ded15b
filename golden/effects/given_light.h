#pragma once
#include "golden/effects/effect.h"

/// Maps whose two parameters are no light (section 4.2): the scene says them.
namespace ptm::golden {

/// Key `coordinates`: [s, t] within -1..1, or a list of them, one for each light.
[[nodiscard]] std::vector<EffectKey> coordinate_keys();

/// Effect::light: light becomes the frame's (s, t), and the sample is lit.
void give_light(const EffectSpec& spec, int frame, std::array<double, 2>& light, bool& lit);

/// Refuses what is no RGB map, other effects of the same object, and a list of another length.
void check_given_light(const EffectSpec& spec, EffectDraw& draw);

}  // namespace ptm::golden
