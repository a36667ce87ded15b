#pragma once
#include <array>
#include <span>

#include "golden/effects/effect.h"

/// The last term of Eq. 8, I_s k_s (N . H)^n, in levels, whatever N . H is taken from.
namespace ptm::golden {

/// Keys `ks` (0 to 511/256, default 0.5) and `exponent` (1 to 255, default 20).
[[nodiscard]] std::vector<EffectKey> specular_keys();

/// Makes the draw's pass 0 evaluate `set` with the half-vector, and notes ks, exponent and the
/// power's table, 255 (i / 255)^n. Throws InputError if the draw has a specular term already.
void add_specular_term(const EffectSpec& spec, EffectDraw& draw, int set);

/// Effect::texel: ks 255 (value[0] / 255)^n in all channels. In [0, 255 ks]: value[0] is within
/// 0..255.
void specular_addend(const DrawExtras& extras, std::span<const double> values, Rgb& addend);
/// Effect::pixel: min(255, color + addend).
void add_to_pixel(const DrawExtras& extras, const Rgb& addend, Rgb& color);

}  // namespace ptm::golden
