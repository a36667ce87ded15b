#pragma once
#include "contract/formats.h"
#include "contract/registers.h"
#include "model/reference/eval_config.h"

/// Texel formats of a map: contract/formats.toml, docs/spec/unit.md, "Draw descriptor".
namespace ptm::reference {

using contract::TextureFormat;

/// What the table says of a format: any code of the register's three bits.
[[nodiscard]] constexpr const contract::FormatRow& format_row(TextureFormat format) {
  return contract::kFormats[static_cast<std::size_t>(format)];
}

/// The format of a map with three polynomials a texel, or one and a colour.
[[nodiscard]] constexpr TextureFormat map_format(bool rgb, bool palettised = false) {
  if (palettised) return rgb ? TextureFormat::palette_rgb : TextureFormat::palette_lrgb;
  return rgb ? TextureFormat::rgb : TextureFormat::lrgb;
}

/// Bits of a coefficient in its word: F of docs/spec/unit.md, "Words".
[[nodiscard]] constexpr int field_bits(const EvalConfig& config) {
  return config.coef_bits > 8 ? config.coef_bits : 8;
}
/// Coefficients of a word, and words of the six of a polynomial.
[[nodiscard]] constexpr int coefficients_a_word(const EvalConfig& config) {
  return contract::coefficients_a_word(config.coef_bits);
}
[[nodiscard]] constexpr int polynomial_words(const EvalConfig& config) {
  return 6 / coefficients_a_word(config);
}

/// The map's own words of a texel, which depend on how many coefficients a word holds.
[[nodiscard]] constexpr const contract::FormatWords& format_words(TextureFormat format,
                                                                  const EvalConfig& config) {
  return contract::kFormatWords[static_cast<std::size_t>(coefficients_a_word(config) - 2)]
                               [static_cast<std::size_t>(format)];
}

/// Planes of 32-bit words of the map's own polynomials and colour, 0 for none.
[[nodiscard]] constexpr int map_planes(TextureFormat format, const EvalConfig& config) {
  return format_words(format, config).planes;
}

}  // namespace ptm::reference
