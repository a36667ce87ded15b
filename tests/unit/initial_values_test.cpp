// Scenes with random bits in everything that reset does not set: pixels, cycles and counters stay.
// All scenes: initial_values_slow_test.cpp.
#include "tests/unit/initial_values.h"

namespace ptm::testbench {
namespace {

class InitialValues : public testing::TestWithParam<const char*> {};

TEST_P(InitialValues, ChangeNothingThatLeavesTheUnit) { expect_no_difference(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Scenes, InitialValues,
                         testing::Values("plane_one_texel", "combine_replace", "effect_all",
                                         "small_unit_palettes"),
                         [](const auto& scene) { return std::string(scene.param); });

}  // namespace
}  // namespace ptm::testbench
