// Units as large as they may be, of other ways and with other parts, which are built when first
// asked for: caches of 64 KiB with one and two ways, one TMU, and all that effects need.
#include "tests/rtl/large_units.h"

namespace ptm::tests {
namespace {

struct LargeUnit {
  const char* name;
  reference::EvalConfig config;
  reference::UnitConfig unit;
};

/// 64 KiB of one way have the most sets that a tag bank may have.
const std::array<LargeUnit, 3> kUnits{
    {{"OneWay",
      {.filter_frac = 4},
      {.cache_kib = 64, .ways = 1, .fragment_fifo = 1024, .miss_fifo = 256}},
     {"TwoWaysTwoTmus",
      {.lum_frac = 4, .filter_frac = 4},
      {.tmus = 2, .cache_kib = 64, .ways = 2, .fragment_fifo = 1023, .miss_fifo = 255}},
     {"FourWaysOneTmuAndEffects",
      {.lum_frac = 4, .filter_frac = 4},
      {.tmus = 1,
       .cache_kib = 64,
       .ways = 4,
       .fragment_fifo = 1024,
       .miss_fifo = 256,
       .eval_lanes = 3,
       .extra_sets = 4,
       .extra_passes = 4,
       .half_vector = true,
       .stages = reference::effects::kStages}}}};

/// The unit of the test's parameter as a variant: `make` cannot capture, and so stands alone.
const LargeUnit* chosen = nullptr;
testbench::RtlUnitVariant variant_of(const LargeUnit& large) {
  chosen = &large;
  return {large.name, large.config, large.unit,
          [] { return testbench::make_rtl_unit(chosen->config, chosen->unit); }};
}

struct Case {
  LargeUnit unit;
  Condition condition;
};
std::vector<Case> cases() {
  std::vector<Case> all;
  for (const LargeUnit& unit : kUnits) {
    for (const Condition& condition : kFillingConditions) all.push_back({unit, condition});
  }
  return all;
}

class SlowLargeUnitExact : public testing::TestWithParam<Case> {};

TEST_P(SlowLargeUnitExact, HasTheCycleAndTheValueOfEveryPixelAndEveryCounterOfFramesThatFillIt) {
  expect_large_unit_exact(variant_of(GetParam().unit), GetParam().condition, 12);
}

INSTANTIATE_TEST_SUITE_P(Units, SlowLargeUnitExact, testing::ValuesIn(cases()),
                         [](const auto& tested) {
                           return std::string(tested.param.unit.name) + tested.param.condition.name;
                         });

class SlowLargeUnit : public testing::TestWithParam<LargeUnit> {};

TEST_P(SlowLargeUnit, KeepsMoreLinesThanACacheOf16KibCouldAndFillsItsFifoAndItsRing) {
  const testbench::RtlUnitVariant variant = variant_of(GetParam());
  EXPECT_LT(misses_of_a_second_sweep(variant), 1024U - 256U);
  // A beat in every register besides, and in those of effects' stages
  EXPECT_GE(accepted_while_blocked(variant),
            static_cast<std::size_t>(variant.unit.fragment_fifo) + 25);
  const std::size_t asked = asked_without_answers(variant).size();
  EXPECT_LE(asked, static_cast<unsigned>(variant.unit.miss_fifo));
  EXPECT_GT(asked + static_cast<unsigned>(variant.unit.tmus),
            static_cast<unsigned>(variant.unit.miss_fifo));
}

INSTANTIATE_TEST_SUITE_P(Units, SlowLargeUnit, testing::ValuesIn(kUnits),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::tests
