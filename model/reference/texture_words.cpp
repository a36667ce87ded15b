#include "model/reference/texture_words.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "model/reference/fragment.h"
#include "model/reference/texel_format.h"

namespace ptm::reference {
namespace {

template <class Field>
std::uint32_t pack_word(const Field* fields, int count, int bits) {
  std::uint32_t word = 0;
  for (int k = 0; k < count; ++k) word |= std::uint32_t{fields[k]} << (k * bits);
  return word;
}

Six<Value> six(const std::uint16_t* coef) {
  Six<Value> values{};
  std::copy_n(coef, 6, values.begin());
  return values;
}

}  // namespace

TextureLayout layout_of(const EvalConfig& config, const StoredTexture& texture) {
  if (std::max(texture.width, texture.height) > kLargestSide) {
    throw std::invalid_argument("a map of " + std::to_string(texture.width) + " x " +
                                std::to_string(texture.height) + " texels, expected at most " +
                                std::to_string(kLargestSide) + " a side");
  }
  return {texture.width,      texture.height,
          texture.rgb,        map_planes(map_format(texture.rgb), config),
          field_bits(config), coefficients_a_word(config)};
}

std::vector<std::uint32_t> pack_texture(const TextureLayout& layout, const StoredTexture& texture) {
  std::vector<std::uint32_t> words(layout.words());
  const auto polynomials =
      static_cast<std::size_t>(format_row(map_format(texture.rgb)).polynomials);
  std::size_t texel = 0;
  for (std::uint64_t y = 0; y < static_cast<std::uint64_t>(layout.height); ++y) {
    for (std::uint64_t x = 0; x < static_cast<std::uint64_t>(layout.width); ++x, ++texel) {
      const std::uint16_t* coef = &texture.coef[texel * polynomials * 6];
      const int coef_planes = layout.planes - (texture.rgb ? 0 : 1);
      for (int plane = 0; plane < coef_planes; ++plane) {
        words[layout.word(plane, x, y)] =
            pack_word(coef + plane * layout.a_word, layout.a_word, layout.field_bits);
      }
      if (!texture.rgb) {
        words[layout.word(coef_planes, x, y)] = pack_word(&texture.color[texel * 3], 3, 8);
      }
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
