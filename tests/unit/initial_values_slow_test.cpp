// Every scene with random bits in everything that reset does not set.
#include "tests/unit/initial_values.h"

namespace ptm::testbench {
namespace {

class InitialValuesOfAllScenes : public testing::TestWithParam<std::string> {};

TEST_P(InitialValuesOfAllScenes, ChangeNothingThatLeavesTheUnit) {
  expect_no_difference(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Scenes, InitialValuesOfAllScenes, testing::ValuesIn(unit_scene_names()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace ptm::testbench
