// Timing `exact` against docs/spec/unit-timing.md stepped cycle by cycle.
#include "model/pipeline/unit/texture_unit.h"

#include <gtest/gtest.h>

#include <memory>

#include "model/pipeline/unit/memory_target.h"
#include "tests/pipeline/random_unit.h"
#include "tests/pipeline/stepped_unit.h"

namespace ptm::pipeline {
namespace {

using reference::UnitCounter;
using tests::RandomUnit;
using tests::SteppedUnit;

const sc_core::sc_time& clock_period() {
  static const sc_core::sc_time period(1, sc_core::SC_NS);
  return period;
}

/// A unit with its memory. All of a process are built before any runs.
struct Bench {
  MemoryTarget memory;
  TextureUnit unit;

  Bench(const std::string& name, const reference::UnitConfig& config,
        const std::vector<reference::Draw>& draws, const StreamTiming& timing,
        const MemoryModel& model, const reference::EvalConfig& eval = {})
      : memory((name + "_memory").c_str(), make_memory(model), {}, clock_period()),
        unit((name + "_unit").c_str(), config, draws, timing, {}, clock_period(), eval) {
    unit.memory.socket.bind(memory.socket);
  }

  UnitFrameResult run(const UnitFrame& frame) {
    memory.reset();
    return unit.run(frame, kPatience).result;
  }
};

void expect_equal(const UnitFrameResult& exact, const UnitFrameResult& stepped,
                  std::uint64_t seed) {
  SCOPED_TRACE(std::string("seed ").append(std::to_string(seed)));
  ASSERT_EQ(exact.taken.size(), stepped.taken.size());
  for (std::size_t n = 0; n < exact.taken.size(); ++n) {
    ASSERT_EQ(exact.taken[n], stepped.taken[n]) << "pixel " << n;
  }
  EXPECT_EQ(exact.answered, stepped.answered);
  for (std::size_t n = 0; n < reference::kUnitCounters; ++n) {
    EXPECT_EQ(exact.counters.value[n], stepped.counters.value[n])
        << reference::unit_counter_names()[n];
  }
}

void expect_stepped_units(std::uint64_t first_seed, std::uint64_t units, bool with_effects) {
  std::vector<RandomUnit> cases;
  std::vector<std::unique_ptr<Bench>> benches;
  for (std::uint64_t n = 0; n < units; ++n) {
    const RandomUnit& c = cases.emplace_back(first_seed + n, with_effects);
    reference::validate(c.unit);
    for (const auto& draw : c.draws) ASSERT_EQ(reference::check_draw(draw, 1 << 26, c.unit), 0U);
    benches.push_back(std::make_unique<Bench>(std::string("n").append(std::to_string(n)), c.unit,
                                              c.draws, c.timing, c.memory, c.eval));
  }
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  for (std::uint64_t n = 0; n < units; ++n) {
    const RandomUnit& c = cases[n];
    const auto memory = make_memory(c.memory);
    SteppedUnit stepped(c.unit, c.draws, c.timing, *memory, c.eval);
    for (const UnitFrame& frame :
         {UnitFrame{c.fragments, false}, UnitFrame{c.fragments, c.keep_cache}}) {
      const UnitFrameResult want = stepped.run(frame);
      expect_equal(benches[n]->run(frame), want, first_seed + n);
      std::uint64_t classes = 0;
      for (std::size_t k = 3; k <= 7; ++k) classes += want.counters.value[k];
      EXPECT_EQ(classes, want.counters[UnitCounter::cycles]);
    }
    if (testing::Test::HasFailure()) break;
  }
}

class TextureUnits : public testing::TestWithParam<std::uint64_t> {};

TEST_P(TextureUnits, EqualTheSteppedRulesInEveryPixelsCycleAndEveryCounter) {
  expect_stepped_units(GetParam() * 40, 40, false);
}

TEST_P(TextureUnits, WithEffectsEqualTheSteppedRulesInEveryPixelsCycleAndEveryCounter) {
  expect_stepped_units(GetParam() * 40, 40, true);
}

TEST(RandomUnits, ReachEveryCounter) {
  reference::UnitCounters sum;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    const RandomUnit c(seed, seed >= 60);
    const auto memory = make_memory(c.memory);
    const auto result = SteppedUnit(c.unit, c.draws, c.timing, *memory, c.eval).run({c.fragments});
    for (std::size_t n = 0; n < sum.value.size(); ++n) sum.value[n] += result.counters.value[n];
  }
  for (std::size_t n = 0; n < sum.value.size(); ++n) {
    // K is seldom empty while the ring is full: a beat that owns slots is on its way to it.
    const bool rare = n == static_cast<std::size_t>(UnitCounter::cycles_ring_full);
    EXPECT_GT(sum.value[n], rare ? 0U : 20U) << reference::unit_counter_names()[n];
  }
}

INSTANTIATE_TEST_SUITE_P(Random, TextureUnits, testing::Range<std::uint64_t>(0, 8));

}  // namespace
}  // namespace ptm::pipeline
