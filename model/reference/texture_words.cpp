#include "model/reference/texture_words.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "model/reference/fragment.h"
#include "model/reference/texel_format.h"

namespace ptm::reference {
namespace {

template <class Field>
std::uint32_t pack_word(const Field* fields, int bits) {
  return static_cast<std::uint32_t>(fields[0]) | static_cast<std::uint32_t>(fields[1]) << bits |
         static_cast<std::uint32_t>(fields[2]) << (2 * bits);
}

Six<Value> six(const std::uint16_t* coef) {
  Six<Value> values{};
  std::copy_n(coef, 6, values.begin());
  return values;
}

}  // namespace

TextureLayout layout_of(const EvalConfig& config, const StoredTexture& texture) {
  if (config.coef_bits > 10) {
    throw std::invalid_argument("coef_bits = " + std::to_string(config.coef_bits) +
                                ", expected at most 10: three coefficients share a 32-bit word");
  }
  if (std::max(texture.width, texture.height) > kLargestSide) {
    throw std::invalid_argument("a map of " + std::to_string(texture.width) + " x " +
                                std::to_string(texture.height) + " texels, expected at most " +
                                std::to_string(kLargestSide) + " a side");
  }
  return {texture.width, texture.height, map_planes(map_format(texture.rgb)),
          std::max(8, config.coef_bits)};
}

std::vector<std::uint32_t> pack_texture(const TextureLayout& layout, const StoredTexture& texture) {
  std::vector<std::uint32_t> words(layout.words());
  const auto polynomials =
      static_cast<std::size_t>(format_row(map_format(texture.rgb)).polynomials);
  std::size_t texel = 0;
  for (std::uint64_t y = 0; y < static_cast<std::uint64_t>(layout.height); ++y) {
    for (std::uint64_t x = 0; x < static_cast<std::uint64_t>(layout.width); ++x, ++texel) {
      const std::uint16_t* coef = &texture.coef[texel * polynomials * 6];
      for (int half = 0; half < static_cast<int>(polynomials) * 2; ++half) {
        words[layout.word(half, x, y)] = pack_word(coef + half * 3, layout.field_bits);
      }
      if (!texture.rgb) words[layout.word(2, x, y)] = pack_word(&texture.color[texel * 3], 8);
    }
  }
  return words;
}

LrgbOperands<> lrgb_operands(const StoredTexture& texture, std::size_t texel, Value lu, Value lv) {
  LrgbOperands<> in;
  in.coef = six(&texture.coef[texel * 6]);
  in.bias = texture.bias;
  in.shift = texture.shift;
  std::copy_n(&texture.color[texel * 3], 3, in.rgb.begin());
  in.lu = lu;
  in.lv = lv;
  return in;
}

RgbOperands<> rgb_operands(const StoredTexture& texture, std::size_t texel, Value lu, Value lv) {
  RgbOperands<> in;
  for (std::size_t c = 0; c < 3; ++c) in.coef[c] = six(&texture.coef[(texel * 3 + c) * 6]);
  in.bias = texture.bias;
  in.shift = texture.shift;
  in.lu = lu;
  in.lv = lv;
  return in;
}

}  // namespace ptm::reference
