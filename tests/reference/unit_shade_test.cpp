// The whole of a fragment against the contract read a second way.
#include <gtest/gtest.h>

#include "model/reference/unit/shade.h"
#include "tests/reference/unit_oracle.h"

namespace ptm::reference {
namespace {

using tests::UnitOracle;
using tests::UnitScene;
using tests::UnitSceneMaker;

TEST(UnitShade, EqualsTheContractReadWithRationalsOnRandomScenes) {
  std::array<int, 5> formats{};
  std::array<int, 6> combines{};
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    UnitSceneMaker maker(seed);
    const UnitScene scene = maker.scene();
    const UnitOracle oracle(scene);
    for (int n = 0; n < 100; ++n) {
      const UnitFragment f = maker.fragment(scene);
      const Draw& draw = scene.state.draws[f.draw];
      ++formats[static_cast<std::size_t>(draw.format)];
      ++combines[static_cast<std::size_t>(draw.combine)];
      const ShadeTrace trace = shade_trace(scene.config, scene.state, f);
      for (unsigned k = 0; k < kFields; ++k) {
        ASSERT_EQ(trace.filtered[k], oracle.field(f, static_cast<int>(k)))
            << "seed " << seed << " field " << k << ": " << tests::describe(f);
      }
      ASSERT_EQ(trace.pixel, oracle.pixel(f)) << "seed " << seed << ": " << tests::describe(f);
    }
  }
  for (const int count : formats) EXPECT_GT(count, 1000);
  for (const int count : combines) EXPECT_GT(count, 1000);
}

TEST(UnitShade, WithEffectsEqualsTheContractReadWithRationalsOnRandomScenes) {
  std::array<int, 5> formats{}, sets{}, passes{};
  std::array<int, 8> stages{};
  int lightened = 0, unlit = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    UnitSceneMaker maker(seed, true);
    const UnitScene scene = maker.scene();
    const UnitOracle oracle(scene);
    for (int n = 0; n < 120; ++n) {
      const UnitFragment f = maker.fragment(scene);
      const Draw& draw = scene.state.draws[f.draw];
      ++formats[static_cast<std::size_t>(draw.format)];
      ++sets[static_cast<std::size_t>(draw.effects.sets)];
      ++passes[static_cast<std::size_t>(draw.effects.passes)];
      ++stages[draw.effects.stages];
      const ShadeTrace trace = shade_trace(scene.config, scene.state, f);
      for (unsigned k = 0; k < kFields; ++k) {
        ASSERT_EQ(trace.filtered[k], oracle.field(f, static_cast<int>(k)))
            << "seed " << seed << " field " << k << ": " << tests::describe(f);
      }
      const UnitOracle::Extra extra = oracle.extra_of(f);
      ASSERT_EQ(trace.value, extra.value) << "seed " << seed << ": " << tests::describe(f);
      for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(trace.addend[c], extra.addend[c]);
      ASSERT_EQ(trace.pixel, oracle.pixel(f)) << "seed " << seed << ": " << tests::describe(f);
      ASSERT_EQ(shade(scene.config, scene.state, f), trace.pixel);
      lightened += extra.addend[0] > 0 && (draw.effects.stages & 4) != 0 ? 1 : 0;
      unlit += !f.lit && draw.effects.passes > 0 ? 1 : 0;
    }
  }
  for (const auto& counts : {formats, sets, passes}) {
    for (const int count : counts) EXPECT_GT(count, 300);
  }
  for (unsigned mask = 0; mask < 8; ++mask) {
    if ((mask & ~effects::kStages) == 0) {
      EXPECT_GT(stages[mask], 300);
    }
  }
  EXPECT_GT(lightened, effects::kStages == 7 ? 1000 : -1);
  EXPECT_GT(unlit, 1000);
}

TEST(UnitShade, OfManyFragmentsEqualsEachAlone) {
  UnitSceneMaker maker(7);
  const UnitScene scene = maker.scene();
  std::vector<UnitFragment> fragments;
  for (int n = 0; n < 500; ++n) fragments.push_back(maker.fragment(scene));
  std::vector<UnitPixel> pixels(fragments.size());
  shade_all(scene.config, scene.state, fragments, pixels);
  for (std::size_t n = 0; n < pixels.size(); ++n) {
    EXPECT_EQ(pixels[n], shade(scene.config, scene.state, fragments[n]))
        << tests::describe(fragments[n]);
  }
}

/// One LRGB texel of coefficients 100 + n and colour 200, 150, 100 with biases 100.
UnitState one_texel() {
  UnitState state;
  const StoredTexture map{1, 1, false, {100, 101, 102, 103, 104, 180}, {200, 150, 100}, {}, {}};
  Draw draw;
  draw.map = append_map(kBase, std::span(&map, 1), state.memory);
  draw.bias.fill(100);
  state.draws.push_back(draw);
  return state;
}

TEST(UnitShade, OfATextureOfOneTexelIsThatTexelWhereverOneLooks) {
  UnitState state = one_texel();
  UnitFragment f;
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp}) {
    state.draws[0].wrap_u = state.draws[0].wrap_v = wrap;
    for (const std::int32_t u : {-(1 << 28), -1, 0, 1, 1 << 19, (1 << 20) - 1, (1 << 28) - 1}) {
      f.u = u;
      f.v = -u - 1;
      const UnitPixel pixel = shade(kBase, state, f);
      // a5 - bias = 80: 80 * 200 / 255 = 62.7, 47.06, 31.4
      EXPECT_EQ(pixel.rgb, (std::array<std::uint8_t, 3>{63, 47, 31})) << "u = " << u;
      EXPECT_EQ(pixel.alpha, 255);
    }
  }
}

TEST(UnitShade, IsBlackWhereTheLightIsBehindTheSurfaceWhateverTheShifts) {
  UnitState state = one_texel();
  state.draws[0].shift = {-4, -4, 0, 15, 3, -2};
  UnitFragment f;
  f.lu = 200;
  f.lit = false;
  EXPECT_EQ(shade(kBase, state, f).rgb, (std::array<std::uint8_t, 3>{}));
  f.lit = true;
  EXPECT_NE(shade(kBase, state, f).rgb, (std::array<std::uint8_t, 3>{}));
}

/// A scene's textures and palettes in the words of another width.
UnitState stored_as(const UnitScene& scene, const EvalConfig& config) {
  UnitState state;
  state.draws = scene.state.draws;
  for (int p = 0; p < 4; ++p) {
    append_lrgb_palette(config, scene.lrgb_palettes[static_cast<std::size_t>(p)], p,
                        state.palettes);
  }
  set_rgb_palette(config, scene.rgb_palette, state.palettes);
  for (std::size_t d = 0; d < state.draws.size(); ++d) {
    const tests::DrawSource& source = scene.sources[d];
    Draw& draw = state.draws[d];
    if (!source.map.empty()) draw.map = append_map(config, source.map, state.memory);
    if (!source.palette_map.empty())
      draw.map = append_palette_map(source.palette_map, state.memory);
    if (draw.color) draw.color_texture = append_picture(source.color, state.memory);
  }
  return state;
}

TEST(UnitShade, IsTheSameWhereTheSameIntegersLieTwoAWordInsteadOfThree) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    UnitSceneMaker maker(seed);
    EvalConfig narrow = kBase;
    narrow.coef_bits = seed % 2 == 0 ? 8 : 10;
    EvalConfig wide = narrow;
    wide.coef_bits = seed % 3 == 0 ? 11 : 12;
    const UnitScene scene = maker.scene(narrow);
    const UnitState three = stored_as(scene, narrow), two = stored_as(scene, wide);
    for (int n = 0; n < 50; ++n) {
      const UnitFragment f = maker.fragment(scene);
      ASSERT_EQ(shade(wide, two, f), shade(narrow, three, f))
          << "seed " << seed << ": " << tests::describe(f);
    }
  }
}

TEST(UnitShade, OfAPictureAloneIsThePictureAndItsAlphaWithNoFlagSet) {
  UnitState state;
  const StoredPicture picture{2, 1, {10, 20, 30, 40, 50, 60, 70, 80}};
  Draw draw;
  draw.format = TextureFormat::none;
  draw.combine = Combine::replace;
  draw.color = true;
  draw.color_texture = append_picture(std::span(&picture, 1), state.memory);
  state.draws.push_back(draw);
  EXPECT_EQ(check_draw(draw, state.memory.size()), 0U);
  UnitFragment f;
  f.u = 1 << 18;  // the centre of the left texel
  f.v = 1 << 19;
  EXPECT_EQ(shade(kBase, state, f), (UnitPixel{0, 0, {10, 20, 30}, 40, false, false}));
  f.u = 3 << 18;
  EXPECT_EQ(shade(kBase, state, f), (UnitPixel{0, 0, {50, 60, 70}, 80, false, false}));
  f.u = 1 << 19;  // between them
  EXPECT_EQ(shade(kBase, state, f), (UnitPixel{0, 0, {30, 40, 50}, 60, false, false}));
}

TEST(UnitShade, TellsOfLimitsInTheEvaluatorAndOfNoneInTheCombine) {
  UnitState state = one_texel();
  const StoredPicture white{1, 1, {255, 255, 255, 255}};
  Draw& draw = state.draws[0];
  draw.color_texture = append_picture(std::span(&white, 1), state.memory);
  draw.color = true;
  draw.combine = Combine::add;
  UnitPixel pixel = shade(kBase, state, UnitFragment{});
  EXPECT_EQ(pixel.rgb, (std::array<std::uint8_t, 3>{255, 255, 255}));
  EXPECT_FALSE(pixel.color_saturated);
  draw.shift[5] = -3;  // a5 = 640: 640 * 200 / 255 is too much for a byte, yet not for ten bits
  draw.combine = Combine::replace;
  pixel = shade(kBase, state, UnitFragment{});
  EXPECT_TRUE(pixel.color_saturated);
  EXPECT_FALSE(pixel.lum_saturated);
  draw.shift[5] = -4;
  EXPECT_TRUE(shade(kBase, state, UnitFragment{}).lum_saturated);
}

}  // namespace
}  // namespace ptm::reference
