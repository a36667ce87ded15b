// What makes a draw illegal, the unit's parameters, and the counters' names.
#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <stdexcept>
#include <string>

#include "model/reference/unit/draw.h"
#include "model/reference/unit/unit_config.h"
#include "model/reference/unit/unit_counters.h"

namespace ptm::reference {
namespace {

/// 21 x 9 LRGB and a 4 x 4 picture: 6 * 3 * 3 = 54 lines from 10, levels of 3 * 1, 2 * 1, 1 and 1
/// tiles behind each other, and a line of a picture.
Draw legal() {
  Draw draw;
  draw.map = {21, 9, 5, {10, 64, 73, 79, 82}};
  draw.color_texture = {4, 4, 3, {85, 86, 87}};
  draw.color = true;
  draw.combine = Combine::decal;
  return draw;
}
constexpr std::uint64_t kLines = 88;

TEST(CheckDraw, FindsNothingInALegalDrawThatFillsTheMemoryToItsLastLine) {
  EXPECT_EQ(check_draw(legal(), kLines), 0U);
  Draw largest;
  largest.map = {4096, 4096, 1, {}};
  EXPECT_EQ(check_draw(largest, 1024 * 1024 * 3), 0U);
  EXPECT_EQ(check_draw(largest, 1024 * 1024 * 3 - 1), kBadAddress);
}

TEST(CheckDraw, CountsTheLinesOfALevelAsItsTilesTimesItsPlanes) {
  const TextureLevels map{21, 9, 5, {}};
  const std::array<std::uint64_t, 5> tiles{6 * 3, 3 * 1, 2 * 1, 1, 1};  // 21x9 10x4 5x2 2x1 1x1
  for (int l = 0; l < 5; ++l) {
    for (const int planes : {1, 3, 6}) {
      EXPECT_EQ(level_lines(map, planes, l),
                tiles[static_cast<std::size_t>(l)] * static_cast<std::uint64_t>(planes));
    }
  }
}

struct Case {
  const char* what;
  std::function<void(Draw&)> change;
  unsigned errors;
};

void expect_cases(const std::vector<Case>& cases) {
  for (const Case& c : cases) {
    Draw draw = legal();
    c.change(draw);
    EXPECT_EQ(check_draw(draw, kLines), c.errors) << c.what;
  }
}

TEST(CheckDraw, SetsTheFirstBitForASideOf0OrAbove4096) {
  expect_cases({{"width 0, whose height has four levels",
                 [](Draw& d) {
                   d.map.width = 0;
                   d.map.levels = 4;
                 },
                 kBadSize},
                {"height 0", [](Draw& d) { d.map.height = 0; }, kBadSize},
                {"width 4097", [](Draw& d) { d.map.width = 4097; }, kBadSize},
                {"negative", [](Draw& d) { d.map.height = -4; }, kBadSize},
                {"colour", [](Draw& d) { d.color_texture.height = 4097; }, kBadSize}});
}

TEST(CheckDraw, SetsTheSecondBitForNoLevelOrMoreThanTheSideHas) {
  expect_cases({{"none", [](Draw& d) { d.map.levels = 0; }, kBadLevels},
                {"six of 21 x 9", [](Draw& d) { d.map.levels = 6; }, kBadLevels},
                {"fifteen", [](Draw& d) { d.map.levels = 15; }, kBadLevels},
                {"four of 4 x 4", [](Draw& d) { d.color_texture.levels = 4; }, kBadLevels}});
  for (int side = 1; side <= 4096; ++side) {
    int levels = 1;  // 1 + floor(log2(side)), by halving
    for (int rest = side; rest > 1; rest /= 2) ++levels;
    Draw draw;
    draw.map = {1, side, levels, {}};
    ASSERT_EQ(check_draw(draw, 1 << 20), 0U) << side;
    draw.map.levels = levels + 1;
    ASSERT_EQ(check_draw(draw, 1 << 20), kBadLevels) << side;
  }
}

TEST(CheckDraw, SetsTheThirdBitForAnyLevelThatEndsBeyondTheMemory) {
  for (std::size_t l = 0; l < 5; ++l) {
    Draw draw = legal();
    draw.map.base[l] = kLines - 1;  // three planes
    EXPECT_EQ(check_draw(draw, kLines), kBadAddress) << "level " << l;
  }
  expect_cases({{"colour", [](Draw& d) { d.color_texture.base[2] = kLines; }, kBadAddress},
                {"largest", [](Draw& d) { d.map.base[4] = 0xFFFFFFFFU; }, kBadAddress},
                {"a level it has not", [](Draw& d) { d.map.base[5] = 0xFFFFFFFFU; }, 0}});
  EXPECT_EQ(check_draw(legal(), kLines - 1), kBadAddress);
}

TEST(CheckDraw, SetsTheFourthBitForCodesOfNoMeaningAndMissingTextures) {
  expect_cases({{"format", [](Draw& d) { d.format = TextureFormat{5}; }, kBadControl},
                {"mip", [](Draw& d) { d.mip = Mip{3}; }, kBadControl},
                {"wrap_u", [](Draw& d) { d.wrap_u = Wrap{3}; }, kBadControl},
                {"wrap_v", [](Draw& d) { d.wrap_v = Wrap{3}; }, kBadControl},
                {"combine", [](Draw& d) { d.combine = Combine{6}; }, kBadControl},
                {"no colour to decal", [](Draw& d) { d.color = false; }, kBadControl},
                {"no map to decal", [](Draw& d) { d.format = TextureFormat::none; }, kBadControl},
                {"colour unused", [](Draw& d) { d.combine = Combine::none; }, 0},
                {"neither",
                 [](Draw& d) {
                   d.format = TextureFormat::none;
                   d.combine = Combine::replace;
                   d.color = false;
                 },
                 kBadControl}});
}

TEST(CheckDraw, DoesNotLookAtATextureThatTheDrawHasNot) {
  expect_cases({{"no colour",
                 [](Draw& d) {
                   d.color = false;
                   d.combine = Combine::none;
                   d.color_texture = {0, 9999, 0, {}};
                 },
                 0},
                {"no map",
                 [](Draw& d) {
                   d.format = TextureFormat::none;
                   d.combine = Combine::replace;
                   d.map = {0, 9999, 0, {}};
                 },
                 0}});
}

TEST(CheckDraw, LooksAtAddressesOnlyWhereAllElseIsLegal) {
  expect_cases({{"all wrong",
                 [](Draw& d) {
                   d.map = {0, 8, 15, {}};
                   d.map.base.fill(kLines);
                   d.mip = Mip{3};
                 },
                 kBadSize | kBadLevels | kBadControl}});
}

TEST(UnitConfigCheck, NamesTheFieldItsValueAndWhatIsExpected) {
  validate(UnitConfig{});
  validate(UnitConfig{1, 1, 4, 4, 4, 1, 1});
  validate(UnitConfig{3, 64, 1, 1024, 256, 4, 4});
  const auto sentence = [](const UnitConfig& config) -> std::string {
    try {
      validate(config);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(sentence({.tmus = 4}), "tmus = 4, expected 1 to 3");
  EXPECT_EQ(sentence({.tmus = 0}), "tmus = 0, expected 1 to 3");
  EXPECT_EQ(sentence({.cache_kib = 24}), "cache_kib = 24, expected one of 1, 2, 4, 8, 16, 32, 64");
  EXPECT_EQ(sentence({.ways = 3}), "ways = 3, expected one of 1, 2, 4");
  EXPECT_EQ(sentence({.fragment_fifo = 3}), "fragment_fifo = 3, expected 4 to 1024");
  EXPECT_EQ(sentence({.miss_fifo = 11}), "miss_fifo = 11, expected 12 to 256");
  EXPECT_EQ(sentence({.palette_lrgb_ports = 3}), "palette_lrgb_ports = 3, expected one of 1, 2, 4");
  EXPECT_EQ(sentence({.palette_rgb_ports = 0}), "palette_rgb_ports = 0, expected one of 1, 2, 4");
}

TEST(UnitCounterNames, AreDistinctAndStandWhereTheirNumbersSay) {
  const auto& names = unit_counter_names();
  EXPECT_EQ(std::set<std::string_view>(names.begin(), names.end()).size(), names.size());
  EXPECT_FALSE(names.back().empty());
  const auto name = [&](UnitCounter c) { return names[static_cast<std::size_t>(c)]; };
  EXPECT_EQ(name(UnitCounter::fragments), "fragments");
  EXPECT_EQ(name(UnitCounter::cycles_input_empty), "cycles_input_empty");
  EXPECT_EQ(name(UnitCounter::words), "words");
  EXPECT_EQ(name(UnitCounter::palette_lookups), "palette_lookups");
  EXPECT_EQ(name(UnitCounter::multiplies_combine), "multiplies_combine");
  UnitCounters counters;
  counters.hits(2, 1) = 1;
  counters.misses(3, 0) = 2;
  for (std::size_t n = 0; n < names.size(); ++n) {
    const std::uint64_t expected = names[n] == "hits_d2_color"   ? 1
                                   : names[n] == "misses_d3_map" ? 2
                                                                 : 0;
    EXPECT_EQ(counters.value[n], expected) << names[n];
  }
}

}  // namespace
}  // namespace ptm::reference
