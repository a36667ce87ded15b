// A unit that is as large as it may be: 64 KiB of four ways a TMU, a fragment FIFO of 1,024 beats,
// a ring of 256 lines, filtered fields with four fraction bits, coefficients of twelve bits, of
// which a word holds two. docs/spec/unit-timing.md, Parameters; docs/spec/unit.md, Words.
#include <set>

#include "model/reference/unit/register_map.h"
#include "tests/rtl/large_units.h"

namespace ptm::tests {
namespace {

const testbench::RtlUnitVariant kLarge{"large", testbench::variants::unit_large_evaluator,
                                       testbench::variants::unit_large_unit,
                                       testbench::make_rtl_unit_large};

class RtlLargeUnitExact : public testing::TestWithParam<Condition> {};

TEST_P(RtlLargeUnitExact, HasTheCycleAndTheValueOfEveryPixelAndEveryCounterOfFramesThatFillIt) {
  expect_large_unit_exact(kLarge, GetParam(), 11);
}

INSTANTIATE_TEST_SUITE_P(Conditions, RtlLargeUnitExact, testing::ValuesIn(kFillingConditions),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// A random scene, or one whose maps are drawn without a colour texture.
UnitScene make_wide_scene(UnitSceneMaker& make, bool colored) {
  UnitScene scene = make.scene(kLarge.config);
  spread_luminance(scene);
  for (reference::Draw& draw : scene.state.draws) {
    if (colored || draw.format == reference::TextureFormat::none) continue;
    draw.color = false;
    draw.combine = reference::Combine::none;
  }
  return scene;
}

class RtlWideCoefficients : public testing::TestWithParam<std::tuple<std::uint64_t, bool>> {};

TEST_P(RtlWideCoefficients, HaveTheCycleAndTheValueOfEveryPixelAndEveryCounter) {
  const auto [seed, colored] = GetParam();
  UnitSceneMaker make(seed);
  const UnitScene scene = make_wide_scene(make, colored);
  auto fragments = random_fragments(make, scene, 800);
  for (std::size_t n = 0; n < fragments.size(); ++n) {
    fragments[n].draw = static_cast<std::uint8_t>(n / 50 % scene.state.draws.size());
  }
  expect_same_frames(kLarge,
                     {"Random",
                      pipeline::RandomMemory{.seed = 3, .latency_max = 60},
                      {.seed = 3, .input_gap = 0.2, .output_stall = 0.2}},
                     scene, fragments);
}

constexpr std::array<std::uint64_t, 4> kSeeds{1, 2, 3, 4};
INSTANTIATE_TEST_SUITE_P(Scenes, RtlWideCoefficients,
                         testing::Combine(testing::ValuesIn(kSeeds), testing::Bool()));

TEST(RtlWideCoefficientsScenes, DrawEveryFormatWithAndWithoutAColourTexture) {
  std::set<std::pair<reference::TextureFormat, bool>> drawn;
  for (const std::uint64_t seed : kSeeds) {
    for (const bool colored : {false, true}) {
      UnitSceneMaker make(seed);
      for (const auto& draw : make_wide_scene(make, colored).state.draws) {
        drawn.emplace(draw.format, draw.color);
      }
    }
  }
  EXPECT_EQ(drawn.size(), 9U) << "four formats of maps twice, and none";
}

TEST(RtlWideCoefficientsPort, KeepsTheUpperBitsOfAPalettesWordsWhileNoFragmentIsInside) {
  namespace registers = reference::registers;
  namespace events = reference::events;
  UnitSceneMaker make(2);
  const UnitScene scene = make.scene(kLarge.config);
  const auto unit = kLarge.make();
  unit->reset(true);
  EXPECT_EQ(unit->read(registers::kPaletteUpper), 0U);
  unit->write(registers::kPaletteUpper, 0xfffffff5);
  EXPECT_EQ(unit->read(registers::kPaletteUpper), 5U);
  unit->load(scene.state);
  EXPECT_EQ(unit->read(registers::kPaletteUpper), 0U);
  EXPECT_EQ(unit->read(registers::kEvents), 0U);
  testbench::RtlUnitPins pins{.valid = true, .fragment = make.fragment(scene)};
  pins.write = reference::RegisterWrite{registers::kPaletteUpper, 9};
  ASSERT_TRUE(unit->cycle(pins).ready);
  EXPECT_EQ(unit->read(registers::kPaletteUpper), 0U);
  EXPECT_EQ(unit->read(registers::kEvents), events::kRefused);
  unit->reset(true);
  EXPECT_EQ(unit->read(registers::kPaletteUpper), 0U);
}

TEST(RtlWideCoefficientsPort, ChecksTheLinesOfEveryPlaneOfADraw) {
  const auto unit = kLarge.make();
  unit->reset(true);
  struct Case {
    reference::TextureFormat format;
    std::uint32_t planes;
  };
  for (const Case& c :
       {Case{reference::TextureFormat::lrgb, 4}, Case{reference::TextureFormat::rgb, 9},
        Case{reference::TextureFormat::palette_lrgb, 1},
        Case{reference::TextureFormat::palette_rgb, 1}}) {
    reference::Draw draw;
    draw.format = c.format;
    draw.map = {9, 5, 1, {100}};  // three tiles across, two down
    for (const bool fits : {false, true}) {
      unit->write(reference::registers::kMemoryLines, 100 + 6 * c.planes - (fits ? 0 : 1));
      for (const auto& write : register_writes(draw, 1)) unit->write(write.address, write.data);
      for (int cycle = 0; cycle < 40; ++cycle) (void)unit->cycle({});
      EXPECT_EQ(unit->read(reference::registers::kErrors), fits ? 0U : 4U << 8)
          << "format " << static_cast<int>(c.format);
    }
  }
}

TEST(RtlLargeUnit, IsBuiltAsItIsCalled) {
  const auto unit = kLarge.make();
  unit->reset(true);
  const auto words = capability_words(kLarge.config, kLarge.unit);
  for (std::size_t n = 0; n < words.size(); ++n) {
    EXPECT_EQ(unit->read(static_cast<std::uint16_t>(reference::registers::kCapabilities + n)),
              words[n]);
  }
}

TEST(RtlLargeUnit, KeepsMoreLinesThanACacheOf16KibCould) {
  EXPECT_LT(misses_of_a_second_sweep(kLarge), 1024U - 256U);
}

TEST(RtlLargeUnit, HoldsItsFragmentFifoAnd25BeatsBesidesWhileItIsBlocked) {
  EXPECT_EQ(accepted_while_blocked(kLarge), 1024U + 25);
}

TEST(RtlLargeUnit, AsksForAsManyLinesAsItsRingHasSlotsAndGivesEachATag) {
  const std::vector<std::uint8_t> tags = asked_without_answers(kLarge);
  ASSERT_EQ(tags.size(), 256U);
  for (std::size_t n = 0; n < tags.size(); ++n) EXPECT_EQ(tags[n], n);
}

}  // namespace
}  // namespace ptm::tests
