// Every small scene of four_state.h in a four-state simulator, on the small unit and on the one
// with all that effects need.
#include "tests/rtl/four_state.h"

namespace ptm::tests {
namespace {

class FourStateUnits : public testing::TestWithParam<testbench::RtlUnitVariant> {};

TEST_P(FourStateUnits, GiveNoXAndWhatVerilatorGivesOnEveryScene) {
  const FourStateUnit unit(GetParam(), unit_sources());
  EXPECT_GE(small_scenes().size(), 12U);
  for (const SmallScene& scene : small_scenes()) expect_replayed(GetParam(), unit, scene, 30);
}

INSTANTIATE_TEST_SUITE_P(Small, FourStateUnits,
                         testing::ValuesIn(std::vector<testbench::RtlUnitVariant>(
                             testbench::rtl_unit_variants().end() - 2,
                             testbench::rtl_unit_variants().end())),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::tests
