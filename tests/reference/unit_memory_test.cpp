// Textures in lines, and palettes.
#include "model/reference/unit/unit_memory.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "model/reference/unit/beats.h"
#include "tests/reference/refusal.h"
#include "tests/reference/unit_oracle.h"

namespace ptm::reference {
namespace {

using tests::UnitOracle;
using tests::UnitScene;
using tests::UnitSceneMaker;

/// The fields of a word of a plane as the contract's table of words names them, from the oracle.
std::uint32_t expected_word(const UnitScene& scene, std::size_t d, bool color, int plane, int level,
                            int i, int j) {
  const UnitOracle oracle(scene);
  const Draw& draw = scene.state.draws[d];
  const auto stored = [&](int n) {
    return static_cast<std::uint32_t>(oracle.stored(draw, d, level, n, i, j));
  };
  const auto bytes = [](auto a, auto b, auto c, auto e) { return a | b << 8 | c << 16 | e << 24; };
  if (color) return bytes(stored(22), stored(23), stored(24), stored(25));
  const int bits = std::max(8, scene.config.coef_bits), a_word = bits > 10 ? 2 : 3;
  const auto coefficients = [&](int n) {
    std::uint32_t word = 0;
    for (int k = 0; k < a_word; ++k) word |= stored(n + k) << (k * bits);
    return word;
  };
  const int own = map_planes(draw.format, scene.config);
  if (plane >= own) return coefficients(26 + a_word * (plane - own));
  const auto l = static_cast<std::size_t>(level);
  const auto& source = scene.sources[d];
  switch (draw.format) {
    case TextureFormat::lrgb:
      if (plane == 6 / a_word) return bytes(stored(18), stored(19), stored(20), stored(21));
      [[fallthrough]];
    case TextureFormat::rgb:
      return coefficients(a_word * plane);
    default: {
      const auto& map = source.palette_map[l];
      const std::uint32_t index = map.index[static_cast<std::size_t>(j * map.width + i)];
      if (draw.format == TextureFormat::palette_rgb) return index;
      return bytes(index, stored(18), stored(19), stored(20));
    }
  }
}

/// Every texel of every level and plane: its place is its own, inside the memory, and holds it.
void expect_texture(const UnitScene& scene, std::size_t d, bool color,
                    std::set<std::pair<std::uint32_t, unsigned>>& taken) {
  const Draw& draw = scene.state.draws[d];
  const TextureLevels& texture = color ? draw.color_texture : draw.map;
  const int planes = color ? 1 : array_planes(draw, scene.config);
  for (int level = 0; level < texture.levels; ++level) {
    const std::uint32_t base = texture.base[static_cast<std::size_t>(level)];
    const std::uint64_t end = base + level_lines(texture, planes, level);
    for (int j = 0; j < std::max(1, texture.height >> level); ++j) {
      for (int i = 0; i < std::max(1, texture.width >> level); ++i) {
        for (int plane = 0; plane < planes; ++plane) {
          const TexelPlace at = place_of(texture, planes, level, plane, i, j);
          ASSERT_TRUE(at.line >= base && at.line < end && at.word < 16);
          ASSERT_TRUE(taken.emplace(at.line, at.word).second) << "two texels in a word";
          ASSERT_EQ(scene.state.memory[at.line][at.word],
                    expected_word(scene, d, color, plane, level, i, j))
              << "draw " << d << " level " << level << " plane " << plane << " (" << i << ", " << j
              << ")";
        }
      }
    }
  }
}

TEST(UnitMemory, HoldsEveryTexelOfEveryLevelOnceWhereTheAddressSays) {
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    const UnitScene scene = UnitSceneMaker(seed, seed >= 40).scene();
    std::set<std::pair<std::uint32_t, unsigned>> taken;
    for (std::size_t d = 0; d < scene.state.draws.size(); ++d) {
      const Draw& draw = scene.state.draws[d];
      ASSERT_EQ(check_draw(draw, scene.state.memory.size(), scene.unit, scene.config), 0U);
      if (draw.format != TextureFormat::none) expect_texture(scene, d, false, taken);
      if (draw.color) expect_texture(scene, d, true, taken);
    }
    for (std::uint32_t line = 0; line < scene.state.memory.size(); ++line) {
      for (unsigned word = 0; word < kLineWords; ++word) {
        if (taken.contains({line, word})) continue;
        ASSERT_EQ(scene.state.memory[line][word], 0U);
      }
    }
  }
}

TEST(UnitMemory, LaysThePlanesOfATileBesideEachOther) {
  TextureLevels texture{9, 5, 1, {1000}};
  // three tiles across, two down
  EXPECT_EQ(place_of(texture, 6, 0, 0, 0, 0), (TexelPlace{1000, 0}));
  EXPECT_EQ(place_of(texture, 6, 0, 5, 3, 3), (TexelPlace{1005, 15}));
  EXPECT_EQ(place_of(texture, 6, 0, 0, 4, 0), (TexelPlace{1006, 0}));
  EXPECT_EQ(place_of(texture, 6, 0, 2, 8, 4), (TexelPlace{1000 + 5 * 6 + 2, 0}));
  EXPECT_EQ(place_of(texture, 1, 0, 0, 6, 4), (TexelPlace{1004, 2}));
}

StoredTexture plain_map(int width, int height) {
  StoredTexture map{width, height, false, {}, {}, {}, {}};
  map.coef.resize(static_cast<std::size_t>(width * height) * 6, 7);
  map.color.resize(static_cast<std::size_t>(width * height) * 3, 9);
  return map;
}

TEST(UnitMemory, GivesAMapTheAlphaOfSomethingSolid) {
  std::vector<Line> memory;
  const StoredTexture map = plain_map(1, 1);
  append_map(kBase, std::span(&map, 1), memory);
  ASSERT_EQ(memory.size(), 3U);
  EXPECT_EQ(memory[2][0], 0xFF090909U);
}

TEST(UnitMemory, RefusesWhatDoesNotFitInOneSentenceAndStaysAsItWas) {
  std::vector<Line> memory(5);
  const auto append = [&](std::vector<StoredTexture> levels, const EvalConfig& config = kBase) {
    return tests::refusal([&] { append_map(config, levels, memory); });
  };
  EXPECT_EQ(append({}), "levels = 0, expected 1 to 13");
  EXPECT_EQ(append({plain_map(4097, 1)}),
            "a texture of 4097 x 1 texels, expected 1 to 4096 a side");
  EXPECT_EQ(append({plain_map(0, 3)}), "a texture of 0 x 3 texels, expected 1 to 4096 a side");
  EXPECT_EQ(append({plain_map(5, 3), plain_map(2, 2)}), "level 1 of 2 x 2 texels, expected 2 x 1");
  EXPECT_EQ(append({plain_map(1, 1), plain_map(1, 1)}), "levels = 2, expected at most 1");
  StoredTexture map = plain_map(2, 2);
  map.coef[5] = 256;
  EXPECT_EQ(append({map}), "a coefficient = 256, expected at most 255");
  map = plain_map(2, 2);
  map.coef.pop_back();
  EXPECT_EQ(append({map}), "coefficients of a level = 23, expected 24");
  map = plain_map(2, 2);
  map.color.pop_back();
  EXPECT_EQ(append({map}), "colours of a level = 11, expected 12");
  map = plain_map(2, 2);
  map.coef[5] = 2048;
  EXPECT_EQ(append({map}, {.coef_bits = 11}), "a coefficient = 2048, expected at most 2047");
  StoredTexture other{1, 1, true, std::vector<std::uint16_t>(18), {}, {}, {}};
  EXPECT_EQ(append({plain_map(2, 2), other}), "rgb of a level = 1, expected 0");
  const StoredPaletteMap indices{1, 1, false, {256}, {1, 2, 3}};
  EXPECT_EQ(tests::refusal([&] { append_palette_map(std::span(&indices, 1), memory); }),
            "an index = 256, expected at most 255");
  const StoredPicture picture{2, 1, {1, 2, 3}};
  EXPECT_EQ(tests::refusal([&] { append_picture(std::span(&picture, 1), memory); }),
            "bytes of a level = 3, expected 8");
  EXPECT_EQ(memory, std::vector<Line>(5));
}

TEST(UnitPalettes, HoldTheEntriesInTheirOwnPaletteAndZeroBeyondThem) {
  Palettes palettes;
  append_lrgb_palette(kBase, std::vector<std::uint16_t>{1, 2, 3, 4, 5, 6}, 2, palettes);
  ASSERT_EQ(palettes.lrgb.size(), 3 * kLrgbEntries);
  for (std::size_t e = 0; e < palettes.lrgb.size(); ++e) {
    const std::array<std::uint64_t, 2> first{0x030201, 0x060504};
    EXPECT_EQ(palettes.lrgb[e], e == 512 ? first : (std::array<std::uint64_t, 2>{}));
  }
  std::vector<std::uint16_t> rgb(36);
  for (std::size_t n = 0; n < rgb.size(); ++n) rgb[n] = static_cast<std::uint16_t>(n);
  set_rgb_palette({.coef_bits = 10}, rgb, palettes);
  ASSERT_EQ(palettes.rgb.size(), kRgbEntries);
  EXPECT_EQ(palettes.rgb[1][0], 18U | 19U << 10 | 20U << 20);
  EXPECT_EQ(palettes.rgb[1][5], 33U | 34U << 10 | 35U << 20);
  EXPECT_EQ(palettes.rgb[2], (std::array<std::uint64_t, 6>{}));
}

TEST(UnitPalettes, RefuseTooManyOrTooLargeEntries) {
  Palettes palettes;
  const auto append = [&](std::vector<std::uint16_t> coef, int palette) {
    return tests::refusal([&] { append_lrgb_palette(kBase, coef, palette, palettes); });
  };
  EXPECT_EQ(append(std::vector<std::uint16_t>(257 * 6), 0),
            "entries of a palette = 257, expected at most 256");
  EXPECT_EQ(append(std::vector<std::uint16_t>(7), 0),
            "coefficients of a palette = 7, expected a multiple of 6");
  EXPECT_EQ(append(std::vector<std::uint16_t>(6), 4), "palette = 4, expected at most 3");
  EXPECT_EQ(append(std::vector<std::uint16_t>(6, 256), 0),
            "a coefficient = 256, expected at most 255");
  EXPECT_EQ(tests::refusal(
                [&] { set_rgb_palette(kBase, std::vector<std::uint16_t>(4097 * 18), palettes); }),
            "entries of a palette = 4097, expected at most 4096");
  EXPECT_TRUE(palettes.lrgb.empty() && palettes.rgb.empty());
}

}  // namespace
}  // namespace ptm::reference
