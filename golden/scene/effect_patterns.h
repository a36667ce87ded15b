#pragma once
#include <cstdint>

#include "golden/scene/stuff.h"

/// Flat patterns that effects shade. u, v in 0..1, v down.
namespace ptm::golden {

/// Turned metal: fine rings about the middle, a hub; black beyond its rim, where alpha is 0.
[[nodiscard]] Stuff disc_at(std::uint64_t seed, double u, double v);
/// Dark metal, faintly clouded: its colour is its highlight's.
[[nodiscard]] Stuff metal_at(std::uint64_t seed, double u, double v);
/// A gloss map (steady): bright tiles, dull joints, smears.
[[nodiscard]] Stuff gloss_at(std::uint64_t seed, double u, double v);

}  // namespace ptm::golden
