#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/reference/evaluate.h"

namespace ptm::reference {

/// How the texture unit keeps a map in memory: planes of 32-bit words, each plane in 4 x 4 tiles
/// of one 64-byte line, tiles and the words in them row by row.
///
///     LRGB  3 planes: (a0 a1 a2), (a3 a4 a5), (R G B)
///     RGB   6 planes: (a0 a1 a2), (a3 a4 a5) of red, then green, then blue
///
/// and where coef_bits is above 10, so that a word holds two coefficients,
///
///     LRGB  4 planes: (a0 a1), (a2 a3), (a4 a5), (R G B)
///     RGB   9 planes: (a0 a1), (a2 a3), (a4 a5) of red, then green, then blue
///
/// The first field is in the low bits; coefficient fields are max(8, coef_bits) wide, colour
/// fields 8. Source: HPL-98-131, section 3 (two 24-bit textures); docs/spec/pipeline.md, Words.
struct TextureLayout {
  int width = 0, height = 0;
  bool rgb = false;
  int planes = 3;      ///< 3 or 4 (LRGB), 6 or 9 (RGB)
  int field_bits = 8;  ///< of a coefficient in its word; 8..12
  int a_word = 3;      ///< coefficients in a word

  [[nodiscard]] constexpr std::uint64_t tiles_across() const {
    return (static_cast<std::uint64_t>(width) + 3) / 4;
  }
  [[nodiscard]] constexpr std::uint64_t plane_words() const {
    return tiles_across() * ((static_cast<std::uint64_t>(height) + 3) / 4) * 16;
  }
  [[nodiscard]] constexpr std::uint64_t words() const {
    return plane_words() * static_cast<std::uint64_t>(planes);
  }
  /// Index of the word of one texel in one plane.
  [[nodiscard]] constexpr std::uint64_t word(int plane, std::uint64_t x, std::uint64_t y) const {
    const std::uint64_t tile = (y / 4) * tiles_across() + x / 4;
    return static_cast<std::uint64_t>(plane) * plane_words() + tile * 16 + (y % 4) * 4 + x % 4;
  }
};

/// A quantised map as the unit sees it: stored integers with one bias and shift a coefficient.
struct StoredTexture {
  int width = 0, height = 0;
  bool rgb = false;                   ///< three polynomials a texel instead of one and a colour
  std::vector<std::uint16_t> coef{};  ///< [height][width][rgb ? 3 : 1][6], a0 first
  std::vector<std::uint8_t> color{};  ///< [height][width][3], LRGB only
  std::array<Value, 6> bias{}, shift{};
};

/// Throws std::invalid_argument if a side is longer than 4,096.
[[nodiscard]] TextureLayout layout_of(const EvalConfig& config, const StoredTexture& texture);

/// The memory image, texels beyond the map's edge zero.
[[nodiscard]] std::vector<std::uint32_t> pack_texture(const TextureLayout& layout,
                                                      const StoredTexture& texture);

/// Operands of a texel straight from the stored map.
[[nodiscard]] LrgbOperands<> lrgb_operands(const StoredTexture& texture, std::size_t texel,
                                           Value lu, Value lv);
[[nodiscard]] RgbOperands<> rgb_operands(const StoredTexture& texture, std::size_t texel, Value lu,
                                         Value lv);

/// Field k of a word, which must hold as many.
[[nodiscard]] constexpr Value word_field(std::uint32_t word, int k, int field_bits) {
  return Value{word >> (k * field_bits) & ((1U << field_bits) - 1U)};
}

}  // namespace ptm::reference
