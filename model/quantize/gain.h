#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "model/quantize/gram.h"

/// An LRGB texel's brightness may sit in its luminance or in its colour: colour * L is what shows.
/// Palettes use that freedom, so that an entry tells a shape and the colour its strength.
namespace ptm::quantize {

/// Moves each texel's strength from its luminance to its colour, in place.
///
///     norm(a) = sqrt(a^T G a),   M = max over texels of norm(a) b / 255,   b the brightest channel
///     a' = a M / norm(a)         so that all polynomials have the norm M
///
/// Returns what each colour is to be multiplied by, norm(a) / M: no channel then exceeds 255. A
/// polynomial of norm 0, or a map without colour, is left alone and has the factor 1.
/// `coef` is [texel][6], `color` [texel][3]; sizes that do not agree throw std::invalid_argument.
[[nodiscard]] std::vector<double> equalize_strength(std::span<double> coef,
                                                    std::span<const std::uint8_t> color,
                                                    const Gram& gram);

/// How much each texel's luminance shows once its colour is multiplied by its factor, the weights
/// of make_palette(): |factor * colour|^2 / 3 / 255^2. Empty if nothing shows.
[[nodiscard]] std::vector<double> color_weights(std::span<const std::uint8_t> color,
                                                std::span<const double> factors);

/// The colours with which stored polynomials `p` come nearest to colour * L of the polynomials `a`
/// that they stand for, over the lights of G:
///
///     color' = clamp(round(color * (a^T G p) / (p^T G p)), 0, 255)
///
/// A stored polynomial of norm 0 keeps the colour. [texel][6], [texel][6] and [texel][3].
[[nodiscard]] std::vector<std::uint8_t> refit_colors(std::span<const double> real,
                                                     std::span<const double> stored,
                                                     std::span<const std::uint8_t> color,
                                                     const Gram& gram);

}  // namespace ptm::quantize
