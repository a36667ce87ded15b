// Whole fragments with effects, by hand: where an effect is at its limits, and what is counted.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "model/reference/effects/power_table.h"
#include "model/reference/unit/shade.h"
#include "model/reference/unit/unit_beats.h"

namespace ptm::reference {
namespace {

constexpr UnitConfig kAll{.extra_sets = 4, .extra_passes = 4, .half_vector = true, .stages = 7};

StoredTexture map_of(int width, int height) {
  StoredTexture map{width, height, false, {}, {}, {}, {}};
  map.coef.resize(static_cast<std::size_t>(width * height) * 6, 7);
  map.color.resize(static_cast<std::size_t>(width * height) * 3, 9);
  return map;
}

TEST(UnitFragmentOfAHalfVector, HasItsLightCodesAndIsNoneWithoutThem) {
  PlainUnitSample s;
  s.hu = -0.5;
  s.hv = 0.25;
  const UnitFragment f = quantize_unit_fragment(kBase, Draw{}, s).value();
  EXPECT_EQ(f.hu, -128);
  EXPECT_EQ(f.hv, 64);
  EXPECT_EQ(f.lu, 0);
  s.hu = 2;  // the largest code
  EXPECT_EQ(quantize_unit_fragment(kBase, Draw{}, s).value().hu, 511);
  for (const double none : {2.001, -9.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    PlainUnitSample bad;
    bad.hu = none;
    EXPECT_FALSE(quantize_unit_fragment(kBase, Draw{}, bad).has_value());
    std::swap(bad.hu, bad.hv);
    EXPECT_FALSE(quantize_unit_fragment(kBase, Draw{}, bad).has_value());
  }
}

/// A texel whose own luminance is 100 of colour 51 (20 levels), and two sets that are 255 and 128
/// in any light; half-vector, power, modulate and add.
UnitState highlight(double exponent) {
  UnitState state;
  StoredTexture map = map_of(1, 1);
  map.coef = {0, 0, 0, 0, 0, 100};
  map.color = {51, 51, 51};
  std::vector<StoredSet> sets{{map_of(1, 1)}, {map_of(1, 1)}};
  sets[0][0].coef = {0, 0, 0, 0, 0, 255};
  sets[1][0].coef = {0, 0, 0, 0, 0, 128};
  Draw draw;
  draw.map = append_map(kBase, std::span(&map, 1), sets, state.memory);
  draw.ks = 256;
  draw.effects.sets = 2;
  draw.effects.passes = 2;
  draw.effects.pass = {{{1, true}, {2, false}}};
  draw.effects.stages = 5;
  state.draws.push_back(draw);
  state.tables.push_back(effect_table(exponent));
  EXPECT_EQ(check_draw(draw, state.memory.size(), kAll), 0U);
  return state;
}

int red(const UnitState& state, const UnitFragment& f = {}) {
  const ShadeTrace trace = shade_trace(kBase, state, f);
  EXPECT_EQ(trace.pixel, shade(kBase, state, f));
  return trace.pixel.rgb[0];
}

TEST(Highlight, IsWholeAtTheTopAndFollowsTheExponentBelowIt) {
  for (const double n : {1.0, 20.0, 255.0}) {
    UnitState state = highlight(n);
    EXPECT_EQ(red(state), 255) << "20 + 255";
    state.draws[0].ks = 128;
    EXPECT_EQ(red(state), 148) << "20 + 127.5";
    state.draws[0].ks = 0;
    EXPECT_EQ(red(state), 20);
    state.draws[0].ks = 128;
    state.draws[0].effects.bias[0].fill(0);
    state.draws[0].effects.bias[0][5] = 127;  // the set is 128 now
    const double power = 127.5 * std::pow(128 / 255.0, n);
    EXPECT_NEAR(red(state), 20 + power, 0.51 + 1.0 / 32) << n;
  }
}

TEST(Highlight, IsNoneWhereAllCoefficientsAreZero) {
  UnitState state = highlight(7);
  for (Line& line : state.memory) line.fill(0);
  const ShadeTrace trace = shade_trace(kBase, state, UnitFragment{});
  EXPECT_EQ(trace.value, (std::array<Value, 4>{}));
  EXPECT_EQ(trace.pixel.rgb, (std::array<std::uint8_t, 3>{}));
}

TEST(Highlight, OfASaturatedValueIsWholeAndSetsNoFlag) {
  UnitState state = highlight(3);
  state.draws[0].effects.shift[0][5] = -4;  // 4,080
  state.draws[0].ks = 64;
  const ShadeTrace trace = shade_trace(kBase, state, UnitFragment{});
  EXPECT_EQ(trace.value[0], 1023);
  EXPECT_EQ(trace.pixel.rgb[0], 20 + 64);
  EXPECT_FALSE(trace.pixel.lum_saturated || trace.pixel.color_saturated);
}

TEST(Highlight, IsNoneWhereTheLightIsBehindTheSurfaceWhateverBiasAndShift) {
  UnitState state = highlight(1);
  state.draws[0].effects.bias[0] = {3, 200, 17, 9, 255, 60};
  state.draws[0].effects.shift[0] = {-4, 3, 15, 0, -1, -4};
  state.draws[0].effects.stages = 7;
  UnitFragment f;
  f.lit = false;
  f.hu = 200;
  f.hv = -300;
  const ShadeTrace trace = shade_trace(kBase, state, f);
  EXPECT_EQ(trace.value, (std::array<Value, 4>{}));
  EXPECT_EQ(trace.pixel.rgb, (std::array<std::uint8_t, 3>{}));
}

TEST(Highlight, TakesTheHalfVectorOnlyWhereThePassSaysSo) {
  UnitState state = highlight(1);
  state.draws[0].effects.shift.fill({});
  // Set 0's luminance is 256 hu: a3 = 255, all else 0.
  for (Line& line : state.memory) line.fill(0);
  state.memory[4][0] = 255;  // plane 4: (a3 a4 a5) of set 0
  UnitFragment f;
  f.hu = 128;  // a half
  f.lu = 64;
  EXPECT_EQ(shade_trace(kBase, state, f).value[0], 128);
  state.draws[0].effects.pass[0].half = false;
  EXPECT_EQ(shade_trace(kBase, state, f).value[0], 64);
}

TEST(Highlight, IsScaledByTheModulationIfItsStageActs) {
  UnitState state = highlight(1);
  state.draws[0].ks = 64;
  EXPECT_EQ(red(state), 20 + 64);
  state.draws[0].effects.stages = 7;
  EXPECT_EQ(red(state), 20 + 32);
  state.draws[0].effects.argument = 1;  // green and blue: values of passes that are not run
  EXPECT_EQ(shade(kBase, state, {}).rgb, (std::array<std::uint8_t, 3>{52, 20, 20}));
  state.draws[0].effects.passes = 1;
  EXPECT_EQ(red(state), 20) << "value[1] is 0";
}

TEST(Highlight, OfOneDrawDoesNotShowOnAnother) {
  UnitState state = highlight(1);
  Draw plain = state.draws[0];
  plain.effects.stages = 0;
  state.draws.push_back(plain);  // its passes run all the same; it has no table
  plain.effects = {};
  plain.map.base[0] = static_cast<std::uint32_t>(state.memory.size());
  const StoredTexture map = map_of(1, 1);
  append_map(kBase, std::span(&map, 1), state.memory);
  state.draws.push_back(plain);
  Draw power_alone = state.draws[0];
  power_alone.effects.stages = 4;  // add, with nothing to add
  state.draws.push_back(power_alone);
  UnitFragment f;
  const int with = red(state, f);
  f.draw = 1;
  EXPECT_EQ(red(state, f), 20);
  f.draw = 2;
  EXPECT_EQ(red(state, f), 0) << "7 * 9 / 255 levels";
  f.draw = 3;
  EXPECT_EQ(red(state, f), 20);
  EXPECT_EQ(with, 255);
}

TEST(Highlight, WorksOnAPictureWithoutAMapFromTheTablesFirstEntry) {
  UnitState state;
  const StoredPicture picture{1, 1, {10, 20, 250, 77}};
  Draw draw;
  draw.format = TextureFormat::none;
  draw.combine = Combine::replace;
  draw.color = true;
  draw.color_texture = append_picture(std::span(&picture, 1), state.memory);
  draw.ks = 256;
  draw.effects.stages = 5;
  state.draws.push_back(draw);
  state.tables.emplace_back()[0] = 160;  // 10 levels
  EXPECT_EQ(check_draw(draw, 1, kAll), 0U);
  const UnitPixel pixel = shade(kBase, state, {});
  EXPECT_EQ(pixel.rgb, (std::array<std::uint8_t, 3>{20, 30, 255}));
  EXPECT_EQ(pixel.alpha, 77);
}

std::uint64_t counted(const Draw& draw, int tmus, UnitCounter which, const EvalConfig& eval = {}) {
  UnitConfig config = kAll;
  config.tmus = tmus;
  UnitFragment f;
  f.u = f.v = 12345;
  UnitCounters counters;
  count_fragment(draw, f, config, counters, eval);
  return counters[which];
}

TEST(CountFragmentWithEffects, GivesTheContractsFigures) {
  Draw draw;
  draw.map = {16, 16, 1, {}};
  draw.effects.sets = draw.effects.passes = 4;
  draw.effects.stages = 7;
  draw.effects.argument = 1;
  // Eleven words: three beats of four, of three, of the map's texture alone.
  EXPECT_EQ(counted(draw, 3, UnitCounter::beats), 4U);
  EXPECT_EQ(counted(draw, 3, UnitCounter::words), 11U);
  EXPECT_EQ(counted(draw, 3, UnitCounter::taps), 44U);
  EXPECT_EQ(counted(draw, 3, UnitCounter::multiplies_address), 4U * 4);
  EXPECT_EQ(counted(draw, 3, UnitCounter::multiplies_filter), 30U + 8 * 9);
  EXPECT_EQ(counted(draw, 3, UnitCounter::multiplies_eval), 11U + 4 * 8);
  EXPECT_EQ(counted(draw, 3, UnitCounter::multiplies_effects), 1U + 3);
  EXPECT_EQ(counted(draw, 3, UnitCounter::multiplies_effects, kWide), 2U + 3);
  draw.effects.argument = 0;
  EXPECT_EQ(counted(draw, 3, UnitCounter::multiplies_effects, kWide), 2U + 1);
  draw.effects.stages = 4;
  EXPECT_EQ(counted(draw, 3, UnitCounter::multiplies_effects, kWide), 0U);
  // A palettised map is looked up once, whatever its sets.
  draw.format = TextureFormat::palette_lrgb;
  draw.color = true;
  draw.color_texture = {16, 16, 1, {}};
  EXPECT_EQ(counted(draw, 2, UnitCounter::palette_lookups), 4U);
  EXPECT_EQ(counted(draw, 2, UnitCounter::words), 10U);
  EXPECT_EQ(counted(draw, 2, UnitCounter::multiplies_filter), 27U + 12 + 8 * 9);
  // The first beat has the map's word and the colour's, the others sets' words.
  EXPECT_EQ(counted(draw, 2, UnitCounter::multiplies_address), 8U + 4 * 4);
}

TEST(UnitCounterNames, EndWithTheEffects) {
  EXPECT_EQ(kUnitCounters, 38U);
  EXPECT_EQ(static_cast<int>(UnitCounter::multiplies_effects), 37);
  EXPECT_EQ(unit_counter_names()[37], "multiplies_effects");
  EXPECT_EQ(unit_counter_names()[36], "misses_d3_color");
}

}  // namespace
}  // namespace ptm::reference
