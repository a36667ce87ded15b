// Reset at any time (docs/spec/handshake.md, Reset): whatever the unit holds, and whatever the
// memory still owes it, the next frame is that of a unit that was just switched on.
#include "model/pipeline/simulate_texture_unit.h"
#include "tests/rtl/pin_frame.h"
#include "tests/rtl/small_scenes.h"
#include "tests/rtl/unit_runs.h"

namespace ptm::tests {
namespace {

using pipeline::Cycle;
using pipeline::RandomMemory;

constexpr Cycle kEnd = 100'000;

class RtlUnitReset : public testing::TestWithParam<testbench::RtlUnitVariant> {};

/// Resets of the unit alone in many cycles of a frame; then a frame into which the answers that the
/// memory owed come late. Pixels are the reference's, cycles and counters those of `exact`.
void expect_nothing_left(const testbench::RtlUnitVariant& variant, const UnitScene& scene,
                         const std::vector<reference::UnitFragment>& fragments) {
  const auto unit = variant.make();
  const pipeline::MemoryModel model = RandomMemory{.seed = 4, .latency_max = 60};
  const auto memory = make_memory(model);
  unit->load(scene.state);
  unit->write(0x1000, 3);
  std::vector<pipeline::UnitFrame> frames;
  std::vector<PinFrame> seen;
  std::vector<reference::UnitCounters> counters;
  std::size_t most_owed = 0;
  for (Cycle moment = 1; moment < 260; moment += moment < 40 ? 3 : 17) {
    const PinFrame broken = run_pins(*unit, scene.state, fragments, *memory, {}, moment);
    unit->reset(false);
    EXPECT_EQ(unit->read(0x1003) & 3U, 0U) << "busy, or an error, after a reset in " << moment;
    write_registers(*unit, scene.state);
    const LateAnswers late{broken.owed, 3, moment % 2 + 1};
    most_owed = std::max(most_owed, broken.owed.size());
    seen.push_back(run_pins(*unit, scene.state, fragments, *memory, late, kEnd));
    counters.push_back(unit->counters());
    EXPECT_EQ(unit->read(0x1003) & 7U, 0U) << "reset in " << moment;
    EXPECT_EQ(unit->read(0x1008) & 8U, 0U) << "a dropped answer's line is no failed line";
    expect_pixels(scene, fragments, seen.back().pixels);
    ASSERT_FALSE(testing::Test::HasFailure()) << "reset in cycle " << moment;
    frames.push_back({fragments, false, late.last()});
    unit->write(0x1000, 3);
  }
  EXPECT_GT(most_owed, 8U);
  pipeline::UnitSimulation simulation;
  simulation.unit = variant.unit;
  simulation.eval = variant.config;
  simulation.state = &scene.state;
  simulation.memory = model;
  simulation.frames = {frames.size(), [&](std::size_t n) { return frames[n]; },
                       [&](std::size_t n, pipeline::UnitFrameResult&& exact) {
                         EXPECT_EQ(seen[n].taken, exact.taken) << n;
                         EXPECT_EQ(seen[n].answered, exact.answered) << n;
                         EXPECT_EQ(counters[n], exact.counters) << n;
                       }};
  simulate_texture_unit(simulation);
}

TEST_P(RtlUnitReset, LeavesNothingBehindInWhateverCycleItComes) {
  UnitSceneMaker make(21);
  const UnitScene scene = make.scene(GetParam().config, GetParam().unit);
  expect_nothing_left(GetParam(), scene, random_fragments(make, scene, 60));
}

TEST_P(RtlUnitReset, LeavesNothingBehindOfBeatsThatAreManyAndSplit) {
  const SmallWorld world = make_reset_world(GetParam());
  UnitScene scene;
  scene.config = GetParam().config;
  scene.unit = GetParam().unit;
  scene.state = world.state;
  expect_nothing_left(GetParam(), scene, world.fragments);
}

INSTANTIATE_TEST_SUITE_P(Variants, RtlUnitReset, testing::ValuesIn(unit_variants()),
                         [](const auto& tested) { return std::string(tested.param.name); });

class RtlUnitDrain : public testing::Test {
 protected:
  RtlUnitDrain() : scene_(make_.scene(reference::kBase, 1)) {
    fragments_ = random_fragments(make_, scene_, 20);
    unit_->load(scene_.state);
    unit_->write(0x1000, 3);
    owed_ = run_pins(*unit_, scene_.state, fragments_, *memory_, {}, 14).owed;
  }
  testbench::RtlUnitSeen answer(std::uint8_t tag) {
    testbench::RtlUnitPins pins;
    pins.response = true;
    pins.tag = tag;
    return unit_->cycle(pins);
  }
  /// Cycles until the unit asks for a line of the next frame, none after many.
  std::optional<int> first_request() {
    testbench::RtlUnitPins pins{.valid = true, .fragment = fragments_.front()};
    for (int cycle = 0; cycle < 1000; ++cycle) {
      if (unit_->cycle(pins).request) return cycle;
    }
    return std::nullopt;
  }

  UnitSceneMaker make_{2};
  UnitScene scene_;
  std::vector<reference::UnitFragment> fragments_;
  std::unique_ptr<testbench::RtlUnit> unit_ = testbench::make_rtl_unit_base3();
  std::unique_ptr<pipeline::MemoryTiming> memory_ = make_memory(pipeline::FixedMemory{});
  std::vector<std::uint8_t> owed_;
};

TEST_F(RtlUnitDrain, LastsUntilTheMemoryHasGivenWhatItOwes) {
  ASSERT_GT(owed_.size(), 2U);
  unit_->reset(false);
  write_registers(*unit_, scene_.state);
  for (const std::uint8_t tag : owed_) {
    EXPECT_EQ(unit_->read(0x1003) & 6U, 4U);
    EXPECT_EQ(first_request(), std::nullopt);
    (void)answer(tag);
  }
  EXPECT_TRUE(first_request().has_value());
  EXPECT_EQ(unit_->read(0x1003) & 6U, 0U);
}

TEST_F(RtlUnitDrain, IsOverAtOnceIfTheMemoryWasResetToo) {
  unit_->reset(true);
  write_registers(*unit_, scene_.state);
  EXPECT_EQ(unit_->read(0x1003) & 6U, 0U);
  EXPECT_TRUE(first_request().has_value());
}

TEST_F(RtlUnitDrain, TakesAnAnswerMoreThanWhatIsOwedForAnError) {
  unit_->reset(false);
  write_registers(*unit_, scene_.state);
  for (const std::uint8_t tag : owed_) (void)answer(tag);
  EXPECT_EQ(unit_->read(0x1003) & 2U, 0U);
  (void)answer(owed_.front());
  EXPECT_EQ(unit_->read(0x1003) & 2U, 2U);
}

TEST_F(RtlUnitDrain, GoesOnThroughAnotherReset) {
  unit_->reset(false);
  for (std::size_t n = 0; n + 1 < owed_.size(); ++n) (void)answer(owed_[n]);
  unit_->reset(false);
  write_registers(*unit_, scene_.state);
  EXPECT_EQ(unit_->read(0x1003) & 6U, 4U);
  (void)answer(owed_.back());
  EXPECT_TRUE(first_request().has_value());
}

/// Descriptors and errors of draws are gone: a control alone makes a draw of no size.
TEST_F(RtlUnitDrain, ForgetsDrawsAndTheirErrors) {
  unit_->reset(true);  // with fragments inside it would not take the write
  write_registers(*unit_, scene_.state);
  unit_->write(0, 7);  // a format of no meaning
  for (int n = 0; n < 30; ++n) unit_->write(0x1000, 0);
  EXPECT_EQ(unit_->read(0x1002), 8U);
  unit_->reset(true);
  EXPECT_EQ(unit_->read(0x1002), 0U);
  unit_->write(0x1001, 1000);
  unit_->write(0, 1);
  for (int n = 0; n < 30; ++n) unit_->write(0x1000, 0);
  EXPECT_EQ(unit_->read(0x1002), unsigned{reference::kBadSize | reference::kBadLevels});
}

}  // namespace
}  // namespace ptm::tests
