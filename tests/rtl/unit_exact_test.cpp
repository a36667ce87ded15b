// The RTL unit against the pipeline model's timing `exact`: every pixel's cycle, every response's,
// every counter. SystemC elaborates once a process, and so runs each model.
#include "tests/rtl/exact_frames.h"

namespace ptm::tests {
namespace {

const std::array<Condition, 5> kConditions{
    {{"FixedMemory", pipeline::FixedMemory{}, {}},
     {"FastMemory", pipeline::FixedMemory{.latency = 1, .interval = 1}, {}},
     {"Dram", pipeline::DramMemory{}, {}},
     {"RandomMemoryStallsAndGaps",
      pipeline::RandomMemory{.seed = 3, .latency_max = 60},
      {.seed = 3, .input_gap = 0.3, .output_stall = 0.4}},
     {"FastMemoryStalls",
      pipeline::FixedMemory{.latency = 3, .interval = 1},
      {.seed = 4, .output_stall = 0.6}}}};

struct Case {
  testbench::RtlUnitVariant variant;
  Condition condition;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const auto& variant : unit_variants()) {
    for (const Condition& condition : kConditions) all.push_back({variant, condition});
  }
  return all;
}

class RtlUnitExact : public testing::TestWithParam<Case> {};

TEST_P(RtlUnitExact, HasTheCycleOfEveryPixelAndEveryCounter) {
  const auto& [variant, condition] = GetParam();
  UnitSceneMaker make(std::hash<std::string>{}(condition.name) % 1000);
  const UnitScene scene = make.scene(variant.config);
  expect_same_frames(variant, condition, scene, random_fragments(make, scene, 1500));
}

INSTANTIATE_TEST_SUITE_P(Units, RtlUnitExact, testing::ValuesIn(cases()), [](const auto& tested) {
  return std::string(tested.param.variant.name) + tested.param.condition.name;
});

/// The outer memory sees base and line added modulo 2^26, and a DRAM's banks and rows are those of
/// the sum.
class RtlUnitBase : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RtlUnitBase, IsAddedToEveryRequestsLine) {
  for (const bool small : {false, true}) {
    const testbench::RtlUnitVariant variant = small ? unit_variants().back() : unit_variants()[0];
    UnitSceneMaker make(41);
    UnitScene scene = make.scene(variant.config, variant.unit);
    scene.state.base = GetParam();
    const auto fragments = random_fragments(make, scene, 300);
    const auto unit = variant.make();
    unit->load(scene.state);
    EXPECT_EQ(unit->read(0x1004), GetParam());
    unit->write(0x1000, 3);
    std::vector<std::uint32_t> asked;
    for (int cycle = 0; cycle < 100; ++cycle) {
      testbench::RtlUnitPins pins{.valid = true, .fragment = fragments[0]};
      const auto seen = unit->cycle(pins);
      if (seen.request) asked.push_back(seen.line);
    }
    ASSERT_FALSE(asked.empty());
    for (const std::uint32_t line : asked) {
      EXPECT_LT((line - GetParam()) & 0x3ffffffU, scene.state.memory.size());
    }
    if (!small) expect_same_frames(variant, kConditions[2], scene, fragments);
  }
}

INSTANTIATE_TEST_SUITE_P(Lines, RtlUnitBase,
                         testing::Values(0U, 1U, 0x155555U, 0x2000000U, 0x3fffffdU));

struct EffectCase {
  testbench::RtlUnitVariant variant;
  Condition condition;
  std::uint64_t seed;
};

std::vector<EffectCase> effect_cases() {
  std::vector<EffectCase> all;
  for (const auto& variant : effect_variants()) {
    for (const Condition& condition : kConditions) {
      // 19: palettised maps with four sets, whose ninth word is no index
      for (const std::uint64_t seed : {1U, 2U, 19U}) all.push_back({variant, condition, seed});
    }
  }
  return all;
}

class RtlUnitEffectsExact : public testing::TestWithParam<EffectCase> {};

TEST_P(RtlUnitEffectsExact, HasTheCycleAndTheValueOfEveryPixelAndEveryCounter) {
  const auto& [variant, condition, seed] = GetParam();
  UnitSceneMaker make(seed);
  UnitScene scene = make.scene(variant.config, variant.unit);
  if (seed > 1) spread_luminance(scene);
  EXPECT_TRUE(std::any_of(scene.state.draws.begin(), scene.state.draws.end(),
                          [](const auto& draw) { return draw.effects.passes > 0; }));
  expect_same_frames(variant, condition, scene, random_fragments(make, scene, 1000));
}

INSTANTIATE_TEST_SUITE_P(Units, RtlUnitEffectsExact, testing::ValuesIn(effect_cases()),
                         [](const auto& tested) {
                           return std::string(tested.param.variant.name) +
                                  tested.param.condition.name + "Scene" +
                                  std::to_string(tested.param.seed);
                         });

/// A unit without counters against one with them, and nothing else different.
TEST(RtlUnitWithoutCounters, HasThePixelsAndCyclesOfOneWithThem) {
  UnitSceneMaker make(5);
  const UnitScene scene = make.scene(reference::kBase, 4);
  const auto fragments = random_fragments(make, scene, 300);
  const auto bare = testbench::make_rtl_unit_bare(), whole = testbench::make_rtl_unit_base3();
  for (const Condition& condition : kConditions) {
    SCOPED_TRACE(condition.name);
    std::vector<pipeline::UnitFrameResult> results;
    for (testbench::RtlUnit* unit : {bare.get(), whole.get()}) {
      unit->load(scene.state);
      const auto memory = make_memory(condition.memory);
      results.push_back(unit->run({fragments}, *memory, condition.timing));
      EXPECT_EQ(unit->read(0x1003), 0U) << "idle, without an error";
      EXPECT_EQ(unit->read(0x1008), 1U) << "the end of the frame";
    }
    EXPECT_EQ(results[0].taken, results[1].taken);
    EXPECT_EQ(results[0].answered, results[1].answered);
    EXPECT_EQ(results[0].pixels, results[1].pixels);
    EXPECT_EQ(results[0].counters, reference::UnitCounters{});
    EXPECT_GT(results[1].counters[UnitCounter::cycles], 300U);
  }
}

}  // namespace
}  // namespace ptm::tests
