// The RTL unit's pixels against the reference, on any legal scene.
#include "tests/rtl/unit_runs.h"

namespace ptm::tests {
namespace {

using pipeline::FixedMemory;
using pipeline::RandomMemory;

class RtlUnitValues : public testing::TestWithParam<testbench::RtlUnitVariant> {};

TEST_P(RtlUnitValues, AreTheReferencesUnderRandomLatenciesStallsAndGaps) {
  const auto unit = GetParam().make();
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    UnitSceneMaker make(seed);
    const UnitScene scene = make.scene(GetParam().config);
    const auto fragments = random_fragments(make, scene, 400);
    unit->load(scene.state);
    const auto memory = make_memory(RandomMemory{.seed = seed, .latency_max = 40});
    const pipeline::StreamTiming timing{.seed = seed,
                                        .input_gap = seed % 3 == 0 ? 0.3 : 0,
                                        .output_stall = seed % 2 == 0 ? 0.3 : 0};
    const auto result = unit->run({.fragments = fragments}, *memory, timing);
    ASSERT_FALSE(result.fault) << result.fault->what;
    expect_pixels(scene, fragments, result.pixels);
    expect_sound(result.counters, fragments.size(), GetParam().unit);
    if (HasFailure()) return;
  }
}

TEST_P(RtlUnitValues, StayWhenTheMemoryMakesRequestsWait) {
  const auto unit = GetParam().make();
  UnitSceneMaker make(99);
  const UnitScene scene = make.scene(GetParam().config);
  const auto fragments = random_fragments(make, scene, 400);
  unit->load(scene.state);
  unit->stall_requests(0.7, 5);
  const auto memory = make_memory(FixedMemory{.latency = 20, .interval = 1});
  const auto result = unit->run({.fragments = fragments}, *memory, {});
  ASSERT_FALSE(result.fault) << result.fault->what;
  expect_pixels(scene, fragments, result.pixels);
  expect_sound(result.counters, fragments.size(), GetParam().unit);
}

TEST_P(RtlUnitValues, OfASecondFrameComeFromTheCacheIfItIsKeptAndFromMemoryIfNot) {
  const auto unit = GetParam().make();
  UnitSceneMaker make(7);
  const UnitScene scene = make.scene(GetParam().config);
  const auto fragments = random_fragments(make, scene, 60);
  unit->load(scene.state);
  const auto memory = make_memory(FixedMemory{});
  const auto first = unit->run({.fragments = fragments}, *memory, {});
  const auto again = unit->run({.fragments = fragments}, *memory, {});
  EXPECT_EQ(again.taken, first.taken);
  EXPECT_EQ(again.counters, first.counters);
  const auto kept = unit->run({.fragments = fragments, .keep_cache = true}, *memory, {});
  EXPECT_LT(kept.answered.size(), first.answered.size());
  expect_pixels(scene, fragments, again.pixels);
  expect_pixels(scene, fragments, kept.pixels);
}

INSTANTIATE_TEST_SUITE_P(Variants, RtlUnitValues, testing::ValuesIn(unit_variants()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::tests
