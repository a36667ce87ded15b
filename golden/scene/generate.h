#pragma once
#include <array>
#include <span>
#include <string_view>

#include "golden/scene/textures.h"

namespace ptm::golden {

/// Textures that are computed, so that scenes run without files.
inline constexpr std::array<std::string_view, 11> kPatterns{"checker",  "relief", "studs", "noise",
                                                            "gradient", "disc",   "metal", "gloss",
                                                            "tablet",   "focus",  "tide"};
/// What a pattern can be; the first is the default.
[[nodiscard]] std::span<const std::string_view> pattern_kinds(std::string_view pattern);

/// A pattern at a size, the same for the same seed on every machine.
///
///     checker   8 x 8 squares, light and dark in turn, each a low pyramid; alpha 255 and 0
///     relief    the carved slab of golden/scene/slab.h: its heights, its paint; alpha is its gloss
///     studs     6 x 6 domes on a ground that is red to the right and green downwards; alpha falls
///               from each dome's top
///     noise     every texel a normal and a colour of its own: the hardest thing to filter
///     gradient  flat; red is u, green is v, blue 128; alpha 255 at the left to 0 at the right
///     disc, metal, gloss  flat grounds for effects (golden/scene/effect_patterns.h); gloss is as
///               bright under every light
///     tablet    an inscribed tablet (golden/scene/tablet.h): LRGB, fitted to photographs
///     focus, tide  picture sequences (golden/scene/image_stack.h): RGB, of one parameter
///
/// A map's luminance is its normal's polynomial (golden/bump, over the hemisphere), 255 for full
/// light; LRGB has the pattern's colours beside it. In an RGB map red's normal leans a little to
/// the left and blue's to the right, so that colours turn with the light.
/// A picture has the pattern's colours and alpha.
[[nodiscard]] LoadedTexture generate_texture(const TextureSpec& spec);

}  // namespace ptm::golden
