// What effects add to a draw: its words and fields, what makes it illegal, its registers, its
// memory.
#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "model/reference/unit/texel_fields.h"
#include "tests/reference/refusal.h"
#include "tests/reference/unit_scene.h"

namespace ptm::reference {
namespace {

constexpr std::array<TextureFormat, 4> kMaps{TextureFormat::lrgb, TextureFormat::rgb,
                                             TextureFormat::palette_lrgb,
                                             TextureFormat::palette_rgb};

/// Of a coefficient's width: planes of each format, and words and fields of a set.
struct Packing {
  int coef_bits;
  std::array<int, 4> own;
  int set_words;
  unsigned fields;
};

TEST(EffectWords, OfEveryFormatFollowTheColourAndFillFieldsFrom26On) {
  for (const Packing& p : {Packing{8, {3, 6, 1, 1}, 2, 3}, Packing{10, {3, 6, 1, 1}, 2, 3},
                           Packing{11, {4, 9, 1, 1}, 3, 2}, Packing{12, {4, 9, 1, 1}, 3, 2}}) {
    const EvalConfig config{.coef_bits = p.coef_bits};
    for (std::size_t m = 0; m < kMaps.size(); ++m) {
      for (const bool color : {false, true}) {
        for (int sets = 0; sets <= 4; ++sets) {
          Draw draw;
          draw.format = kMaps[m];
          draw.color = color;
          draw.effects.sets = sets;
          const int own = p.own[m] + (color ? 1 : 0);
          EXPECT_EQ(array_planes(draw, config), p.own[m] + p.set_words * sets);
          ASSERT_EQ(draw_words(draw, config), own + p.set_words * sets);
          Draw plain = draw;
          plain.effects = {};
          for (int word = 0; word < own; ++word) {
            const WordUse use = word_use(draw, config, word),
                          before = word_use(plain, config, word);
            EXPECT_TRUE(use.kind == before.kind && use.texture == before.texture &&
                        use.plane == before.plane && use.field == before.field &&
                        use.fields == before.fields);
          }
          for (int k = 0; k < p.set_words * sets; ++k) {
            const WordUse use = word_use(draw, config, own + k);
            EXPECT_EQ(use.kind, WordKind::coefficients);
            EXPECT_EQ(use.texture, 0);
            EXPECT_EQ(use.plane, p.own[m] + k);
            EXPECT_EQ(use.field, 26 + p.fields * static_cast<unsigned>(k));
            EXPECT_EQ(use.fields, p.fields);
          }
        }
      }
    }
  }
  EXPECT_EQ(kFields, 50U);
}

/// A unit with all that there is, and a draw that uses all of it: 2 x 2 tiles of 3 + 8 planes.
constexpr UnitConfig kAll{.extra_sets = 4, .extra_passes = 4, .half_vector = true, .stages = 7};
Draw all_used() {
  Draw draw;
  draw.map = {8, 8, 1, {}};
  draw.effects.sets = 4;
  draw.effects.passes = 4;
  draw.effects.pass = {{{0, true}, {1, false}, {4, true}, {3, false}}};
  draw.effects.stages = 7;
  return draw;
}
constexpr std::uint64_t kLines = 4 * 11;

struct Case {
  const char* what;
  std::function<void(Draw&, UnitConfig&)> change;
  unsigned errors;
};

void expect_cases(const std::vector<Case>& cases) {
  for (const Case& c : cases) {
    Draw draw = all_used();
    UnitConfig unit = kAll;
    c.change(draw, unit);
    EXPECT_EQ(check_draw(draw, kLines, unit), c.errors) << c.what;
  }
}

TEST(CheckDrawWithEffects, FindsNothingWhereTheUnitHasAllThatTheDrawUses) {
  expect_cases({{"all of it", [](auto&, auto&) {}, 0},
                {"none of it",
                 [](auto& d, auto& u) {
                   d.effects = {};
                   u = {};
                 },
                 0},
                {"a pass beyond the last is not looked at",
                 [](auto& d, auto&) {
                   d.effects.passes = 3;
                   d.effects.pass[3] = {7, true};
                 },
                 0},
                {"set 0 of a palettised LRGB map",
                 [](auto& d, auto&) { d.format = TextureFormat::palette_lrgb; }, 0}});
}

TEST(CheckDrawWithEffects, CountsTheLinesOfAllPlanes) {
  EXPECT_EQ(check_draw(all_used(), kLines - 1, kAll), kBadAddress);
  Draw draw = all_used();
  draw.effects.sets = 3;
  draw.effects.pass[2].set = 3;
  EXPECT_EQ(check_draw(draw, kLines - 8, kAll), 0U);
  EXPECT_EQ(check_draw(draw, kLines - 9, kAll), kBadAddress);
  // Two coefficients a word: 4 + 4 * 3 planes
  constexpr EvalConfig kTwelve{.coef_bits = 12};
  EXPECT_EQ(check_draw(all_used(), 4 * 16, kAll, kTwelve), 0U);
  EXPECT_EQ(check_draw(all_used(), 4 * 16 - 1, kAll, kTwelve), kBadAddress);
}

TEST(CheckDrawWithEffects, SetsTheFourthBitForWhatTheUnitHasNot) {
  expect_cases(
      {{"sets", [](auto&, auto& u) { u.extra_sets = 3; }, kBadControl},
       {"passes", [](auto&, auto& u) { u.extra_passes = 3; }, kBadControl},
       {"power", [](auto&, auto& u) { u.stages = 6; }, kBadControl},
       {"modulate", [](auto&, auto& u) { u.stages = 5; }, kBadControl},
       {"add", [](auto&, auto& u) { u.stages = 3; }, kBadControl},
       {"a stage of no meaning", [](auto& d, auto&) { d.effects.stages = 15; }, kBadControl},
       {"the half-vector", [](auto&, auto& u) { u.half_vector = false; }, kBadControl},
       {"five sets", [](auto& d, auto&) { d.effects.sets = 5; }, kBadControl},
       {"five passes of a unit said to have seven",
        [](auto& d, auto& u) {
          d.effects.passes = 5;
          u.extra_passes = 7;
        },
        kBadControl},
       {"fewer than none", [](auto& d, auto&) { d.effects.sets = -1; }, kBadControl},
       {"effects at all", [](auto&, auto& u) { u = {}; }, kBadControl}});
  EXPECT_EQ(check_draw(all_used(), kLines), kBadControl)
      << "a unit without effects if none is named";
}

TEST(CheckDrawWithEffects, SetsTheFourthBitForPassesOfWhatTheDrawHasNot) {
  expect_cases({{"a set above the draw's", [](auto& d, auto&) { d.effects.sets = 3; }, kBadControl},
                {"set 0 of an RGB map",
                 [](auto& d, auto&) {
                   d.format = TextureFormat::rgb;
                   d.map = {4, 4, 1, {}};
                 },
                 kBadControl},
                {"set 0 of a palettised RGB map",
                 [](auto& d, auto&) { d.format = TextureFormat::palette_rgb; }, kBadControl},
                {"an RGB map's sets alone",
                 [](auto& d, auto&) {
                   d.format = TextureFormat::rgb;
                   d.map = {4, 4, 1, {}};
                   d.effects.pass[0] = {2, true};
                 },
                 0},
                {"no map, and passes",
                 [](auto& d, auto&) {
                   d.format = TextureFormat::none;
                   d.combine = Combine::replace;
                   d.color = true;
                   d.effects.sets = 0;
                   d.effects.passes = 1;
                 },
                 kBadControl},
                {"no map, and sets",
                 [](auto& d, auto&) {
                   d.format = TextureFormat::none;
                   d.combine = Combine::replace;
                   d.color = true;
                   d.effects.passes = 0;
                 },
                 kBadControl},
                {"no map, and stages",
                 [](auto& d, auto&) {
                   d.format = TextureFormat::none;
                   d.combine = Combine::replace;
                   d.color = true;
                   d.effects.sets = d.effects.passes = 0;
                 },
                 0}});
}

TEST(UnitConfigCheck, OfEffectsNamesTheFieldItsValueAndWhatIsExpected) {
  validate(kAll);
  validate(UnitConfig{.extra_passes = 1});
  validate(UnitConfig{.duplicate_lines = false});
  validate(UnitConfig{.counters = false, .duplicate_lines = false});
  EXPECT_EQ(tests::refusal([] { validate(UnitConfig{.counters = false}); }),
            "duplicate_lines = 1, expected 0 to 0");
  const auto refused = [](const UnitConfig& config) {
    return tests::refusal([&] { validate(config); });
  };
  EXPECT_EQ(refused({.extra_passes = 5}), "extra_passes = 5, expected 0 to 4");
  EXPECT_EQ(refused({.extra_sets = 1}), "extra_sets = 1, expected 0 to 0");
  EXPECT_EQ(refused({.extra_sets = 3, .extra_passes = 2}), "extra_sets = 3, expected 0 to 2");
  EXPECT_EQ(refused({.half_vector = true}), "half_vector = 1, expected 0 to 0");
  EXPECT_EQ(refused({.stages = 8}), "stages = 8, expected a part of 7, the stages of this build");
}

using Registers = std::map<unsigned, std::uint32_t>;

Registers registers_of(const UnitState& state) {
  Registers out;
  for (const RegisterWrite& w : register_writes(state)) {
    if (w.address == 0x1005) continue;  // before a palette's words, as often as it changes
    EXPECT_TRUE(out.emplace(w.address, w.data).second) << "written twice: " << w.address;
  }
  return out;
}

/// As the page's table reads; what was not written is 0.
DrawEffects decode(const Registers& registers, unsigned d) {
  const auto at = [&](unsigned address) {
    const auto found = registers.find(address);
    return found == registers.end() ? 0U : found->second;
  };
  DrawEffects e;
  const std::uint32_t passes = at(64 * d + 12);
  e.passes = static_cast<int>(passes % 8);
  for (std::size_t k = 0; k < 4; ++k) {
    e.pass[k].set = static_cast<int>(passes >> (4 * k + 4) & 7);
    e.pass[k].half = (passes >> (4 * k + 7) & 1) != 0;
  }
  e.sets = static_cast<int>(at(64 * d + 13) & 7);
  e.stages = at(64 * d + 13) >> 8 & 255;
  e.argument = at(64 * d + 14);
  for (unsigned s = 0; s < 4; ++s) {
    for (unsigned i = 0; i < 6; ++i) {
      const std::uint32_t word = at(0x2800 + 32 * d + 8 * s + i);
      e.bias[s][i] = word & 0xFFF;
      e.shift[s][i] = static_cast<Value>(word >> 16 & 31) - ((word >> 20 & 1) != 0 ? 32 : 0);
    }
  }
  return e;
}

TEST(RegisterWritesOfEffects, BringAUnitToTheStateTheyWereMadeFrom) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const tests::UnitScene scene = tests::UnitSceneMaker(seed, true).scene();
    Registers registers = registers_of(scene.state);
    for (unsigned d = 0; d < 4; ++d) {
      ASSERT_EQ(decode(registers, d), scene.state.draws[d].effects) << "seed " << seed;
      for (unsigned i = 0; i < 256; ++i) {
        ASSERT_EQ(registers[0x3000 + 256 * d + i], scene.state.tables[d][i]);
      }
    }
  }
}

TEST(RegisterWritesOfEffects, AreNoneForADrawWithoutAndComeBeforeItsControl) {
  const auto count = [](const Draw& draw, const EffectTable& table) {
    return register_writes(draw, 1, table).size();
  };
  Draw draw;
  const std::size_t plain = count(draw, {});
  EXPECT_EQ(plain, 1U + 3 + 6 + 1 + 26);
  draw.effects.argument = 9;
  EXPECT_EQ(count(draw, {}), plain + 1);
  draw.effects.sets = 2;  // their registers whole, though all are 0
  EXPECT_EQ(count(draw, {}), plain + 2 + 12);
  draw.effects.stages = 1;  // and the table
  EXPECT_EQ(count(draw, {}), plain + 2 + 12 + 256);
  EXPECT_EQ(register_writes(draw, 1, {}).back().address, 64U);
}

TEST(RegisterWritesOfEffects, RefuseWhatHasNoField) {
  const auto refused = [](auto change) {
    Draw draw;
    EffectTable table{};
    change(draw.effects, table);
    return tests::refusal([&] { (void)register_writes(draw, 0, table); });
  };
  EXPECT_EQ(refused([](auto& e, auto&) { e.passes = 8; }), "passes = 8, expected 0 to 7");
  EXPECT_EQ(refused([](auto& e, auto&) { e.sets = -1; }), "sets = -1, expected 0 to 7");
  EXPECT_EQ(refused([](auto& e, auto&) { e.pass[2].set = 8; }),
            "set of a pass = 8, expected 0 to 7");
  EXPECT_EQ(refused([](auto& e, auto&) { e.stages = 256; }), "stages = 256, expected 0 to 255");
  EXPECT_EQ(refused([](auto& e, auto&) { e.shift[3][5] = 16; }), "shift = 16, expected -16 to 15");
  EXPECT_EQ(refused([](auto&, auto& table) { table[255] = 4096; }),
            "an entry of the table = 4096, expected 0 to 4095");
}

StoredTexture map_of(int width, int height) {
  StoredTexture map{width, height, false, {}, {}, {}, {}};
  map.coef.resize(static_cast<std::size_t>(width * height) * 6, 7);
  map.color.resize(static_cast<std::size_t>(width * height) * 3, 9);
  return map;
}

TEST(MemoryOfSets, IsRefusedInOneSentenceWhereTheyDoNotBelongToTheMap) {
  std::vector<Line> memory(5);
  const std::vector<StoredTexture> map{map_of(2, 2), map_of(1, 1)};
  const auto append = [&](const std::vector<StoredSet>& sets) {
    return tests::refusal([&] { append_map(kBase, map, sets, memory); });
  };
  EXPECT_EQ(append({{map_of(2, 2)}}), "levels of a set = 1, expected 2");
  EXPECT_EQ(append({{map_of(2, 1), map_of(1, 1)}}), "height of a set's level = 1, expected 2");
  EXPECT_EQ(append({{map_of(2, 2), map_of(2, 1)}}), "width of a set's level = 2, expected 1");
  StoredSet set{map_of(2, 2), map_of(1, 1)};
  EXPECT_EQ(append(std::vector<StoredSet>(5, set)), "sets = 5, expected at most 4");
  set[1].coef[3] = 256;
  EXPECT_EQ(append({set}), "a coefficient = 256, expected at most 255");
  set[1].coef.pop_back();
  EXPECT_EQ(append({set}), "coefficients of a set's level = 5, expected 6");
  const StoredPaletteMap indices{1, 1, false, {5}, {1, 2, 3}};
  std::vector<StoredSet> sets{{map_of(1, 1)}};
  sets[0][0].coef[4] = 16;
  EXPECT_EQ(tests::refusal([&] {
              append_palette_map({.coef_bits = 4}, std::span(&indices, 1), sets, memory);
            }),
            "a coefficient = 16, expected at most 15");
  EXPECT_EQ(memory, std::vector<Line>(5));
}

}  // namespace
}  // namespace ptm::reference
