// The unit in a four-state simulator: no X, and everything as in Verilator, on a few scenes. All of
// them and both units: four_state_slow_test.cpp.
#include "tests/rtl/four_state.h"

#include "model/reference/unit/register_map.h"

namespace ptm::tests {
namespace {

TEST(FourState, TheUnitGivesNoXAndWhatVerilatorGives) {
  const testbench::RtlUnitVariant small = testbench::rtl_unit_variants().back();
  const FourStateUnit unit(small, unit_sources());
  for (const SmallScene& scene : small_scenes()) {
    const std::string name = scene.name;
    if (name == "LrgbBilinear" || name == "PaletteLrgbDecal" || name == "ColorOnly" ||
        name == "RgbTrilinearAdd") {
      expect_replayed(small, unit, scene, 12);
    }
  }
}

/// A unit that is built without some counters or all: a recording of one that has them holds, but
/// for what is read of the counters and of what the unit is built with.
class FourStateWithout : public testing::TestWithParam<reference::UnitConfig> {};

/// Two draws fetch one colour texture by two TMUs, behind three words of LRGB and behind one of a
/// palette's map: what duplicate_lines counts.
SmallWorld make_shared_world(const testbench::RtlUnitVariant& variant) {
  SmallWorld world = make_reset_world(variant);
  reference::UnitState& state = world.state;
  constexpr int kSide = 12;
  constexpr std::size_t kTexels = kSide * kSide;
  reference::Draw& draw = state.draws[1];
  append_lrgb_palette(variant.config, std::vector<std::uint16_t>(6, 77), 0, state.palettes);
  const std::array<reference::StoredPaletteMap, 1> map{
      {{kSide, kSide, false, std::vector<std::uint16_t>(kTexels, 0),
        std::vector<std::uint8_t>(3 * kTexels, 99)}}};
  draw.format = reference::TextureFormat::palette_lrgb;
  draw.map = append_palette_map(map, state.memory);
  draw.color_texture = state.draws[0].color_texture;
  for (std::size_t n = 0; n < world.fragments.size(); ++n) {
    world.fragments[n].draw = static_cast<std::uint8_t>(n % 2);
  }
  return world;
}

TEST_P(FourStateWithout, CountersTheUnitGivesThePixelsAndCyclesOfOneThatHasThem) {
  const testbench::RtlUnitVariant small = testbench::rtl_unit_variants().back();
  testbench::RtlUnitVariant bare = small;
  bare.unit.counters = GetParam().counters;
  bare.unit.duplicate_lines = GetParam().duplicate_lines;
  const FourStateUnit unit(bare, unit_sources());
  const SmallWorld world = make_shared_world(small);
  const auto verilated = small.make();
  UnitRecording recording(*verilated);
  recording.load(world.state);
  (void)recording.frame(world.state, world.fragments, 3);
  std::istringstream lines(recording.text());
  std::string trace;
  unsigned changed = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string command;
    unsigned address = 0, value = 0;
    if (words >> command >> std::hex >> address >> value && command == "Q") {
      const std::size_t counter = (address - 0x2000) / 2;
      unsigned now = value;
      if (counter < reference::kUnitCounters && !has_counter(bare.unit, counter)) now = 0;
      if (address == 0x1012) now = capability_words(bare.config, bare.unit)[0];
      changed += now != value;
      std::ostringstream text;
      text << std::hex << "Q " << address << ' ' << now;
      line = text.str();
    }
    trace += line + '\n';
  }
  EXPECT_GE(changed, bare.unit.counters ? 2U : 20U);  // what is built in, and at least one counter
  const ToolRun run = unit.replay(trace);
  EXPECT_NE(run.output.find("replayed"), std::string::npos) << run.output;
}

INSTANTIATE_TEST_SUITE_P(
    Units, FourStateWithout,
    testing::Values(reference::UnitConfig{.duplicate_lines = false},
                    reference::UnitConfig{.counters = false, .duplicate_lines = false}),
    [](const auto& tested) { return tested.param.counters ? "DuplicateLines" : "Any"; });

}  // namespace
}  // namespace ptm::tests
