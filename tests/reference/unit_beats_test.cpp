// The beats of a fragment: what they read, where seams split them, what they count.
#include "model/reference/unit/unit_beats.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/reference/unit_oracle.h"

namespace ptm::reference {
namespace {

using tests::UnitOracle;
using tests::UnitScene;
using tests::UnitSceneMaker;

/// Word, texture, plane and level of each TMU, and each tap's texel, against the oracle's columns.
void expect_word(const UnitScene& scene, const UnitFragment& f, const Beat& beat, int word,
                 const BeatWord& got) {
  const Draw& draw = scene.state.draws[f.draw];
  const bool wide = scene.config.coef_bits > 10;  // two coefficients a word
  const int own = map_planes(draw.format, scene.config);
  const int planes = own + (wide ? 3 : 2) * draw.effects.sets;
  const int words = planes + (draw.color ? 1 : 0);
  ASSERT_EQ(got.present, word < words);
  if (!got.present) {
    EXPECT_EQ(got.taps, 0U);
    return;
  }
  const bool color = draw.color && word == own;  // the sets' words come behind it
  EXPECT_EQ(got.word, word);
  EXPECT_EQ(got.texture, color ? 1 : 0);
  EXPECT_EQ(got.plane, color ? 0 : word > own && draw.color ? word - 1 : word);
  const UnitOracle::Level choice = UnitOracle::choose(draw, f, color);
  if (beat.footprint == 1 && choice.weight == 0) {
    EXPECT_EQ(got.taps, 0U);
    return;
  }
  const int level = choice.index + beat.footprint;
  EXPECT_EQ(got.level, level);
  const TextureLevels& texture = color ? draw.color_texture : draw.map;
  const auto along = [&](Wrap wrap, std::int32_t u, std::int32_t axis, int side) {
    const int steps = 2 * beat.probe + 1 - (1 << f.probes_log2);
    const tests::Wide moved =
        tests::floor_divide(2 * tests::Wide{u} + tests::Wide{steps} * axis, 2);
    return UnitOracle::column(wrap, draw.bilinear, moved, std::max(1, side >> level));
  };
  const auto column = along(draw.wrap_u, f.u, f.axis_u, texture.width);
  const auto row = along(draw.wrap_v, f.v, f.axis_v, texture.height);
  for (unsigned t = 0; t < kTaps; ++t) {
    const bool right = t % 2 != 0, below = t / 2 != 0;
    const bool fetched = (!right || column.weight != 0) && (!below || row.weight != 0);
    ASSERT_EQ((got.taps >> t & 1U) != 0, fetched) << "tap " << t;
    if (!fetched) continue;
    const TapRead& tap = got.tap[t];
    ASSERT_EQ(tap.i, right ? column.next : column.texel);
    ASSERT_EQ(tap.j, below ? row.next : row.texel);
    EXPECT_EQ(tap.tile_x, tap.i / 4);
    EXPECT_EQ(tap.tile_y, tap.j / 4);
    EXPECT_EQ(tap.tag_bank(), static_cast<unsigned>(tap.tile_y % 2 * 2 + tap.tile_x % 2));
    EXPECT_EQ(tap.data_bank(), static_cast<unsigned>(tap.j % 2 * 2 + tap.i % 2));
    const int planes_of = color ? 1 : planes;
    EXPECT_EQ(tap.place, place_of(texture, planes_of, level, got.plane, tap.i, tap.j));
  }
}

bool has_two_footprints(const Draw& draw, const UnitFragment& f) {
  const bool map = draw.format != TextureFormat::none;
  return (map && UnitOracle::choose(draw, f, false).weight != 0) ||
         (draw.color && UnitOracle::choose(draw, f, true).weight != 0);
}

void expect_beats(const UnitScene& scene, const UnitFragment& f, int tmus) {
  const Draw& draw = scene.state.draws[f.draw];
  UnitConfig config;
  config.tmus = tmus;
  const std::vector<Beat> beats = fragment_beats(draw, f, config, scene.config);
  const int words = draw_words(draw, scene.config);
  const int footprints = has_two_footprints(draw, f) ? 2 : 1;
  const int groups = (words + tmus - 1) / tmus;
  ASSERT_EQ(beats.size(), static_cast<std::size_t>(groups * footprints) << f.probes_log2);
  for (std::size_t n = 0; n < beats.size(); ++n) {
    const int number = static_cast<int>(n);
    EXPECT_EQ(beats[n].group, number % groups);
    EXPECT_EQ(beats[n].footprint, number / groups % footprints);
    EXPECT_EQ(beats[n].probe, number / groups / footprints);
    EXPECT_EQ(beats[n].last, n + 1 == beats.size());
    for (int t = 0; t < tmus; ++t) {
      expect_word(scene, f, beats[n], beats[n].group * tmus + t,
                  beats[n].tmu[static_cast<std::size_t>(t)]);
    }
  }
}

TEST(FragmentBeats, GoByProbeFootprintAndGroupAndReadTheTexelsOfTheContract) {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    UnitSceneMaker maker(seed, seed >= 60);
    const UnitScene scene = maker.scene();
    for (int n = 0; n < 60; ++n) {
      const UnitFragment f = maker.fragment(scene);
      expect_beats(scene, f, maker.in(1, 3));
      if (HasFailure()) FAIL() << "seed " << seed << ": " << tests::describe(f);
    }
  }
}

/// Whether no two different tiles of a TMU share a tag bank and no two texels a data bank.
bool fits_the_banks(const Beat& beat) {
  for (const BeatWord& word : beat.tmu) {
    std::map<unsigned, std::pair<int, int>> tiles, texels;
    for (unsigned t = 0; t < kTaps; ++t) {
      if ((word.taps >> t & 1U) == 0) continue;
      const TapRead& tap = word.tap[t];
      const std::pair tile{tap.tile_x, tap.tile_y}, texel{tap.i, tap.j};
      if (tiles.emplace(tap.tag_bank(), tile).first->second != tile) return false;
      if (texels.emplace(tap.data_bank(), texel).first->second != texel) return false;
    }
  }
  return true;
}

TEST(SplitBeat, SplitsExactlyWhatDoesNotFitTheBanksIntoPartsThatDo) {
  std::map<std::size_t, int> parts_seen;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    UnitSceneMaker maker(seed);
    const UnitScene scene = maker.scene();
    for (int n = 0; n < 100; ++n) {
      const UnitFragment f = maker.fragment(scene);
      for (const Beat& beat :
           fragment_beats(scene.state.draws[f.draw], f, UnitConfig{}, scene.config)) {
        const std::vector<Beat> parts = split_beat(beat);
        ++parts_seen[parts.size()];
        ASSERT_EQ(parts.size() == 1, fits_the_banks(beat)) << tests::describe(f);
        ASSERT_TRUE(parts.size() > 1 || parts[0] == beat);
        for (std::size_t t = 0; t < kTmusMax; ++t) {
          unsigned all = 0;
          for (const Beat& part : parts) {
            ASSERT_TRUE(fits_the_banks(part)) << tests::describe(f);
            ASSERT_EQ(all & part.tmu[t].taps, 0U) << "a tap twice";
            all |= part.tmu[t].taps;
            ASSERT_EQ(part.sub_last, &part == &parts.back());
          }
          ASSERT_EQ(all, beat.tmu[t].taps);
        }
      }
    }
  }
  EXPECT_GT(parts_seen[1], 1000);
  EXPECT_GT(parts_seen[2], 100);
  EXPECT_GT(parts_seen[4], 20);
}

/// A bilinear LRGB draw of a side, and a fragment between its last and first texel both ways.
Draw square(int side) {
  Draw draw;
  draw.map = {side, side, 1, {}};
  return draw;
}

TEST(SplitBeat, HappensAtTheSeamOfOddSidesAndOfAnOddNumberOfTiles) {
  UnitFragment corner;  // u = v = 0: half way
  for (int side = 1; side <= 64; ++side) {
    const std::vector<Beat> beats = fragment_beats(square(side), corner, UnitConfig{});
    ASSERT_EQ(beats.size(), 1U);
    const int tiles = (side + 3) / 4;
    const bool collides = side > 1 && (side % 2 != 0 || (tiles % 2 != 0 && tiles > 1));
    EXPECT_EQ(split_beat(beats[0]).size(), collides ? 4U : 1U) << side;
  }
  UnitFragment edge;
  edge.v = 1 << 18;
  std::vector<Beat> parts = split_beat(fragment_beats(square(5), edge, UnitConfig{})[0]);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].tmu[0].taps, 0b0101U);
  EXPECT_EQ(parts[1].tmu[0].taps, 0b1010U);
  std::swap(edge.u, edge.v);
  parts = split_beat(fragment_beats(square(5), edge, UnitConfig{})[0]);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].tmu[0].taps, 0b0011U);
  EXPECT_EQ(parts[1].tmu[0].taps, 0b1100U);
  parts = split_beat(fragment_beats(square(5), corner, UnitConfig{})[0]);
  ASSERT_EQ(parts.size(), 4U);
  for (unsigned t = 0; t < 4; ++t) EXPECT_EQ(parts[t].tmu[0].taps, 1U << t);
}

std::uint64_t counted(const Draw& draw, const UnitFragment& f, int tmus, UnitCounter which) {
  UnitConfig config;
  config.tmus = tmus;
  UnitCounters counters;
  count_fragment(draw, f, config, counters);
  return counters[which];
}

TEST(CountFragment, OfABilinearLrgbTexelGivesTheContractsFigures) {
  const Draw draw = square(16);
  UnitFragment f;
  f.u = f.v = 12345;
  for (const int tmus : {1, 2, 3}) {
    const auto beats = static_cast<std::uint64_t>((3 + tmus - 1) / tmus);
    EXPECT_EQ(counted(draw, f, tmus, UnitCounter::fragments), 1U);
    EXPECT_EQ(counted(draw, f, tmus, UnitCounter::pixels), 1U);
    EXPECT_EQ(counted(draw, f, tmus, UnitCounter::beats), beats);
    EXPECT_EQ(counted(draw, f, tmus, UnitCounter::bank_conflicts), 0U);
    EXPECT_EQ(counted(draw, f, tmus, UnitCounter::words), 3U);
    EXPECT_EQ(counted(draw, f, tmus, UnitCounter::taps), 12U);
    EXPECT_EQ(counted(draw, f, tmus, UnitCounter::palette_lookups), 0U);
    EXPECT_EQ(counted(draw, f, tmus, UnitCounter::multiplies_address), 4 * beats);
    EXPECT_EQ(counted(draw, f, tmus, UnitCounter::multiplies_filter), 30U);
    EXPECT_EQ(counted(draw, f, tmus, UnitCounter::multiplies_eval), 11U);
    EXPECT_EQ(counted(draw, f, tmus, UnitCounter::multiplies_combine), 0U);
    EXPECT_EQ(counted(draw, f, tmus, UnitCounter::cycles), 0U);
  }
}

TEST(CountFragment, OfSplitBeatsCountsWordsTapsAndMultipliesOnce) {
  UnitFragment corner;
  EXPECT_EQ(counted(square(5), corner, 3, UnitCounter::beats), 4U);
  EXPECT_EQ(counted(square(5), corner, 3, UnitCounter::bank_conflicts), 3U);
  EXPECT_EQ(counted(square(5), corner, 3, UnitCounter::words), 3U);
  EXPECT_EQ(counted(square(5), corner, 3, UnitCounter::taps), 12U);
  EXPECT_EQ(counted(square(5), corner, 3, UnitCounter::multiplies_address), 4U);
  EXPECT_EQ(counted(square(5), corner, 3, UnitCounter::multiplies_filter), 30U);
}

TEST(CountFragment, OfPalettesCountsTapsLookedUpAndTheirFields) {
  Draw draw = square(16);
  UnitFragment f;
  f.u = f.v = 12345;
  draw.format = TextureFormat::palette_lrgb;
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::palette_lookups), 4U);
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::multiplies_filter), 27U);
  draw.format = TextureFormat::palette_rgb;
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::palette_lookups), 4U);
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::multiplies_filter), 54U);
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::multiplies_eval), 24U);
  draw.bilinear = false;
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::palette_lookups), 1U);
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::multiplies_filter), 0U);
}

TEST(CountFragment, OfTwoTexturesLevelsAndProbesAddsUpByHand) {
  Draw draw = square(16);
  draw.map.levels = 5;
  draw.mip = Mip::linear;
  draw.color = true;
  draw.combine = Combine::decal;
  draw.color_texture = {16, 16, 1, {}};  // no second level: one footprint
  UnitFragment f;
  f.u = f.v = 12345;
  f.lod = 100;
  f.probes_log2 = 1;
  f.axis_u = 100;
  // A probe: LRGB (3 words) and colour in the first footprint, LRGB in the second.
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::words), 2U * (4 + 3));
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::taps), 2U * 4 * (4 + 3));
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::beats), 2U * 2 * 2);
  // Two beats a footprint, the second with the colour word alone, fetched or not.
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::multiplies_address), 2U * 2 * ((2 + 4) + (2 + 4)));
  // With two TMUs the second beat has the third plane and the colour word.
  EXPECT_EQ(counted(draw, f, 2, UnitCounter::multiplies_address), 2U * 2 * ((2 + 4) + (2 + 8)));
  // 30 and 12 of the colour word; 30 and 10 lerps between levels
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::multiplies_filter), 2U * (30 + 12 + 30 + 10));
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::multiplies_eval), 11U);
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::multiplies_combine), 6U);
  draw.combine = Combine::modulate;
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::multiplies_combine), 3U);
  draw.format = TextureFormat::none;
  draw.combine = Combine::replace;
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::words), 2U);
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::multiplies_eval), 0U);
  EXPECT_EQ(counted(draw, f, 3, UnitCounter::multiplies_combine), 0U);
}

}  // namespace
}  // namespace ptm::reference
