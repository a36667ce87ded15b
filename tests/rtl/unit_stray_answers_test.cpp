// Answers that nobody waits for: of tags beyond the ring, beyond what is in use, and already
// answered, in the middle of frames. docs/spec/unit-timing.md, Tags.
#include "model/reference/unit/register_map.h"
#include "tests/rtl/drive_frame.h"
#include "tests/rtl/unit_runs.h"

namespace ptm::tests {
namespace {

namespace registers = reference::registers;
namespace events = reference::events;

class RtlUnitStrayAnswers : public testing::TestWithParam<testbench::RtlUnitVariant> {};

bool same(const testbench::RtlUnitSeen& a, const testbench::RtlUnitSeen& b) {
  return a.ready == b.ready && a.pixel_valid == b.pixel_valid &&
         (!a.pixel_valid || a.pixel == b.pixel) && a.request == b.request &&
         (!a.request || (a.line == b.line && a.tag == b.tag));
}

/// The frame with them and without: the same at every pin in every cycle, the same counters; one
/// sticky bit, one event and the first one's tag apart.
TEST_P(RtlUnitStrayAnswers, ChangeNothingButTheBitsThatTellThem) {
  UnitSceneMaker make(52);
  const UnitScene scene = make.scene(GetParam().config, GetParam().unit);
  const auto fragments = random_fragments(make, scene, 250);
  const auto unit = GetParam().make();
  const unsigned slots = static_cast<unsigned>((GetParam().unit.miss_fifo + 3) / 4 * 4);
  std::array<DrivenFrame, 2> frames;
  std::array<reference::UnitCounters, 2> counters;
  for (const bool strays : {false, true}) {
    unit->load(scene.state);
    unit->write(registers::kCommand, registers::kInvalidate | registers::kClear);
    DrivenFrame& frame = frames[strays];
    frame = drive_frame(*unit, scene.state, fragments, slots,
                        {.seed = 9, .stalls = true, .latency_max = 60, .strays = strays});
    expect_pixels(scene, fragments, frame.pixels);
    counters[strays] = unit->counters();
    EXPECT_EQ(unit->read(registers::kState), strays ? frame.strays.at(0) << 8 | 2U : 0U);
    EXPECT_EQ(unit->read(registers::kEvents), events::kIdle | (strays ? events::kWrongTag : 0U));
  }
  EXPECT_EQ(counters[0].value, counters[1].value);
  ASSERT_EQ(frames[0].seen.size(), frames[1].seen.size());
  for (std::size_t cycle = 0; cycle < frames[0].seen.size(); ++cycle) {
    ASSERT_TRUE(same(frames[0].seen[cycle], frames[1].seen[cycle])) << "cycle " << cycle;
  }
  const std::vector<std::uint8_t>& tags = frames[1].strays;
  const auto below = std::ranges::count_if(tags, [slots](unsigned tag) { return tag < slots; });
  const auto beyond = std::ranges::count_if(tags, [slots](unsigned tag) { return tag >= slots; });
  EXPECT_GT(below, 10) << "slots that are not in use";
  EXPECT_GT(beyond, 10) << "tags of no slot";
  EXPECT_GT(frames[1].aliases, 10U) << "the low bits of a slot in use";
}

INSTANTIATE_TEST_SUITE_P(Units, RtlUnitStrayAnswers, testing::ValuesIn(unit_variants()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::tests
