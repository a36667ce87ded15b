#include "testbench/run/unit_map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "testbench/run/map_parts.h"
#include "tests/program/small_map.h"

namespace ptm::testbench {
namespace {

using golden::MapKind;

constexpr std::array<std::array<int, 2>, 6> kSizes{
    {{1, 1}, {1, 7}, {6, 1}, {5, 3}, {8, 8}, {13, 6}}};

/// A map that is taken verbatim, all texels the same.
golden::PtmMap even_map(MapKind kind, int width, int height) {
  golden::PtmMap map = tests::small_map(kind, width, height);
  const std::size_t stride = map.polynomials() * 6;
  for (std::size_t i = stride; i < map.coef.size(); ++i) map.coef[i] = map.coef[i - stride];
  for (std::size_t i = 3; i < map.color.size(); ++i) map.color[i] = map.color[i - 3];
  return map;
}

/// The mean of `n` values that lie `stride` apart.
template <class Value>
double mean(const std::vector<Value>& values, std::size_t first, std::size_t stride,
            std::size_t n) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += values[first + i * stride];
  return sum / static_cast<double>(n);
}

TEST(UnitMapLevels, GoDownToOneTexelByHalvesRoundedDown) {
  EXPECT_EQ(full_levels(1, 1), 1);
  EXPECT_EQ(full_levels(2, 1), 2);
  EXPECT_EQ(full_levels(3, 5), 3);
  EXPECT_EQ(full_levels(4096, 1), 13);
  for (const auto& [width, height] : kSizes) {
    const int levels = full_levels(width, height);
    const RealTexture texture = real_texture(even_map(MapKind::lrgb, width, height));
    const UnitMap map = store_unit_map(texture, levels, reference::kBase);
    ASSERT_EQ(map.levels.size(), static_cast<std::size_t>(levels));
    for (int l = 0; l < levels; ++l) {
      const reference::StoredTexture& level = map.levels[static_cast<std::size_t>(l)];
      EXPECT_EQ(level.width, reference::TextureLevels::level_side(width, l));
      EXPECT_EQ(level.height, reference::TextureLevels::level_side(height, l));
    }
    EXPECT_EQ(map.levels.back().width * map.levels.back().height, 1);
  }
}

TEST(UnitMapLevels, OfAnEvenMapHoldItsOwnNumbersWhateverTheSize) {
  for (const MapKind kind : {MapKind::lrgb, MapKind::rgb}) {
    for (const auto& [width, height] : kSizes) {
      const golden::PtmMap file = even_map(kind, width, height);
      const UnitMap map =
          store_unit_map(real_texture(file), full_levels(width, height), reference::kBase);
      EXPECT_EQ(map.rgb, kind == MapKind::rgb);
      EXPECT_EQ(map.how, "taken verbatim");
      const std::size_t stride = file.polynomials() * 6;
      for (const reference::StoredTexture& level : map.levels) {
        for (std::size_t i = 0; i < level.coef.size(); ++i) {
          ASSERT_EQ(level.coef[i], file.coef[i % stride]) << width << " x " << height;
        }
        for (std::size_t i = 0; i < level.color.size(); ++i) {
          ASSERT_EQ(level.color[i], file.color[i % 3]);
        }
        EXPECT_EQ(level.color.empty(), map.rgb);
      }
    }
  }
}

TEST(UnitMapLevels, AreMeansOnTheOneGridOfTheMap) {
  for (const MapKind kind : {MapKind::lrgb, MapKind::rgb}) {
    golden::PtmMap file = tests::small_map(kind, 4, 4);
    for (auto& c : file.coef) c = static_cast<std::uint8_t>(c & 0xf0);  // means lie on the grid
    for (auto& c : file.color) c = static_cast<std::uint8_t>(c & 0xf0);
    const UnitMap map = store_unit_map(real_texture(file), 3, reference::kBase);
    ASSERT_EQ(map.levels.size(), 3U);
    for (const reference::StoredTexture& level : map.levels) {
      EXPECT_EQ(level.bias, map.bias);
      EXPECT_EQ(level.shift, map.shift);
    }
    const std::size_t stride = file.polynomials() * 6;
    for (std::size_t i = 0; i < stride; ++i) {
      EXPECT_EQ(map.levels[2].coef[i], mean(file.coef, i, stride, 16)) << i;
    }
    for (std::size_t c = 0; c < map.levels[2].color.size(); ++c) {
      EXPECT_EQ(map.levels[2].color[c], mean(file.color, c, 3, 16));
    }
  }
}

TEST(UnitMapLevels, FillTheRangeOfWiderCoefficientsAndComeNearerToTheMap) {
  golden::PtmMap file = tests::small_map(MapKind::lrgb, 8, 8);
  RealTexture texture = real_texture(file);
  texture.file.reset();  // quantised, not taken as it is
  double before = 0;
  for (const int coef_bits : {8, 10, 11, 12}) {
    reference::EvalConfig config;
    config.coef_bits = coef_bits;
    config.delta_bits = coef_bits + 1;
    const UnitMap map = store_unit_map(texture, 1, config, Strength::stays);
    const auto greatest = *std::max_element(map.levels[0].coef.begin(), map.levels[0].coef.end());
    EXPECT_LT(greatest, 1U << coef_bits);
    EXPECT_GE(greatest, 1U << (coef_bits - 1)) << "a bit would be unused";
    std::vector<reference::Line> memory;
    EXPECT_NO_THROW(append_map(config, map.levels, memory)) << coef_bits;
    EXPECT_EQ(memory.size(), 4U * (coef_bits > 10 ? 4 : 3)) << "2 x 2 tiles";
    if (before > 0) {
      EXPECT_LT(map.rms_error, before) << coef_bits;
    }
    before = map.rms_error;
  }
}

TEST(UnitMapLevels, AreNoMoreThanAskedFor) {
  const RealTexture texture = real_texture(tests::small_map(MapKind::lrgb, 8, 8));
  EXPECT_EQ(store_unit_map(texture, 1, reference::kBase).levels.size(), 1U);
  EXPECT_EQ(store_unit_map(texture, 2, reference::kBase).levels.size(), 2U);
  EXPECT_EQ(store_unit_palette(texture, 2, 4, reference::kBase).indexed.size(), 2U);
}

TEST(UnitMapPalette, HoldsThePolynomialsOfAllLevels) {
  for (const MapKind kind : {MapKind::lrgb, MapKind::rgb}) {
    golden::PtmMap file = tests::small_map(kind, 2, 1);
    const std::size_t stride = file.polynomials() * 6;
    for (std::size_t i = 0; i < stride; ++i) {  // two slopes across each other
      file.coef[i] = static_cast<std::uint8_t>(i % 6 == 3 ? 250 : 100);
      file.coef[stride + i] = static_cast<std::uint8_t>(i % 6 == 4 ? 250 : 100);
    }
    const RealTexture texture = real_texture(file);
    const UnitMap top = store_unit_palette(texture, 1, 8, reference::kBase);
    EXPECT_EQ(top.palette.size(), 2 * stride) << "two texels";
    const UnitMap map = store_unit_palette(texture, 2, 8, reference::kBase);
    EXPECT_EQ(map.palette.size(), 3 * stride) << "two texels and their mean";
    ASSERT_EQ(map.indexed.size(), 2U);
    ASSERT_EQ(map.indexed[0].index.size(), 2U);
    ASSERT_EQ(map.indexed[1].index.size(), 1U);
    const auto mixed = map.indexed[1].index[0];
    EXPECT_NE(mixed, map.indexed[0].index[0]);
    EXPECT_NE(mixed, map.indexed[0].index[1]);
  }
}

TEST(UnitMapPalette, GivesEveryTexelOfEveryLevelAnEntryThatIsThere) {
  for (const MapKind kind : {MapKind::lrgb, MapKind::rgb}) {
    for (const auto& [width, height] : kSizes) {
      const RealTexture texture = real_texture(tests::small_map(kind, width, height));
      const int levels = full_levels(width, height);
      const UnitMap map = store_unit_palette(texture, levels, 5, reference::kBase);
      const std::size_t entries = map.palette.size() / (map.rgb ? 18 : 6);
      EXPECT_LE(entries, 5U);
      ASSERT_EQ(map.indexed.size(), static_cast<std::size_t>(levels));
      for (int l = 0; l < levels; ++l) {
        const reference::StoredPaletteMap& level = map.indexed[static_cast<std::size_t>(l)];
        EXPECT_EQ(level.width, reference::TextureLevels::level_side(width, l));
        EXPECT_EQ(level.height, reference::TextureLevels::level_side(height, l));
        const auto texels = static_cast<std::size_t>(level.width * level.height);
        EXPECT_EQ(level.index.size(), texels);
        EXPECT_EQ(level.color.size(), map.rgb ? 0 : 3 * texels);
        EXPECT_LT(*std::max_element(level.index.begin(), level.index.end()), entries);
      }
    }
  }
}

TEST(PictureLevels, AreRoundedFromMeansThatAreNot) {
  reference::StoredPicture picture{4, 1, std::vector<std::uint8_t>(16, 0)};
  picture.rgba[4] = 1;    // the second texel's red
  picture.rgba[3] = 255;  // the first texel's alpha
  const auto levels = picture_levels(picture, 3);
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_EQ(levels[0].rgba, picture.rgba);
  EXPECT_EQ(levels[1].rgba, (std::vector<std::uint8_t>{1, 0, 0, 128, 0, 0, 0, 0}));
  EXPECT_EQ(levels[2].rgba, (std::vector<std::uint8_t>{0, 0, 0, 64})) << "a quarter, not a half";
}

TEST(PictureLevels, OfOddSizesWeighTexelsByArea) {
  const auto levels = picture_levels({3, 1, {0, 0, 0, 0, 90, 0, 0, 0, 30, 0, 0, 0}}, 2);
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_EQ(levels[1].width, 1);
  EXPECT_EQ(levels[1].rgba[0], 40);
}

}  // namespace
}  // namespace ptm::testbench
