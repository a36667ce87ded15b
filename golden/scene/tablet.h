#pragma once
#include <cstdint>
#include <vector>

#include "golden/scene/textures.h"

namespace ptm::golden {

/// A worn clay tablet with rows of wedges pressed into it, after the neo-Sumerian one of the
/// paper's Figure 5: kTabletLights simulated photographs, fitted as real ones are. LRGB only.
///
/// A photograph's luminance is 0.08 + 0.92 max(0, N.L), of clay without gloss and without cast
/// shadows; lights stand evenly over the dome, 15 to 80 degrees high.
[[nodiscard]] LoadedTexture make_tablet(const TextureSpec& spec);
inline constexpr int kTabletLights = 48;

/// Height in half widths at x, y in [-1, 1], y up.
[[nodiscard]] double tablet_height(std::uint64_t seed, double x, double y);

}  // namespace ptm::golden
