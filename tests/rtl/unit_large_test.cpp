// A unit that is as large as it may be: 64 KiB of four ways a TMU, a fragment FIFO of 1,024 beats,
// a ring of 256 lines, filtered fields with four fraction bits. docs/spec/unit-timing.md,
// Parameters.
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
