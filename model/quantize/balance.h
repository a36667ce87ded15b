#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "model/reference/eval_config.h"

namespace ptm::quantize {

/// What balance_luminance() did, in texels.
struct Balance {
  std::size_t exceeding = 0;  ///< whose luminance went beyond what D6 holds
  std::size_t scaled = 0;     ///< of those, whose colour was scaled up
  std::size_t remaining = 0;  ///< of those, whose luminance still goes beyond: no room in colour
};

/// Makes room for luminance in an LRGB map: where it could exceed what lum_bits and lum_frac hold
/// under one of the lights, the texel's colour is scaled up and its luminance down.
///
///     top  = (2^(lum_bits + lum_frac) - 1) / 2^lum_frac         D6 of docs/spec/datapath.md
///     most = max over lights of L(lu, lv),    b = brightest channel of the colour
///     b'   = min(255, ceil(b most / top)),    k = b' / b        if most > top and 0 < b < 255
///     colour' = round(k colour),  a_i' = a_i / k
///
/// The brightest channel times luminance is unchanged, real-valued; the others move by half a level
/// times L / 255 at most. Black texels are left alone: their luminance does not show.
///
/// `coef` is [texel][6], `color` [texel][3]; both are changed in place. No lights, sizes that do
/// not agree or a coefficient that is not finite throw std::invalid_argument.
Balance balance_luminance(std::span<double> coef, std::span<std::uint8_t> color,
                          std::span<const std::array<double, 2>> lights,
                          const reference::EvalConfig& config);

}  // namespace ptm::quantize
