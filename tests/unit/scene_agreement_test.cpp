// Every scene under scenes/: pixels of reference and RTL, cycles and counters of RTL and the timing
// exact, difference 0, whatever the memory and the world around the unit do.
#include <algorithm>

#include "tests/unit/unit_agreement.h"

namespace ptm::testbench {
namespace {

/// Above it, a scene is run as it says only: the other worlds are covered by the small ones.
constexpr std::size_t kLargeScene = 100'000;

class UnitScenes : public testing::TestWithParam<std::string> {};

TEST_P(UnitScenes, AgreeInEveryPixelCycleAndCounter) {
  UnitJob job = load_unit_scene(GetParam());
  ASSERT_FALSE(job.frames.front().fragments.empty());
  {
    SCOPED_TRACE("as the scene says");
    expect_agreement(job, run_pair(job));
  }
  if (job.frames.front().fragments.size() > kLargeScene) return;
  job.timing = {};
  {
    SCOPED_TRACE("default memory");
    job.memory = pipeline::FixedMemory{};
    expect_agreement(job, run_pair(job));
  }
  {
    SCOPED_TRACE("random latencies, out of order");
    job.memory = pipeline::RandomMemory{11, 2, 300};
    expect_agreement(job, run_pair(job));
  }
  {
    SCOPED_TRACE("random latencies, output stalls and input gaps");
    job.memory = pipeline::RandomMemory{12, 1, 120};
    job.timing.seed = 5;
    job.timing.input_gap = 0.15;
    job.timing.output_stall = 0.3;
    expect_agreement(job, run_pair(job));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, UnitScenes, testing::ValuesIn(unit_scene_names()),
                         [](const auto& scene) { return scene.param; });

TEST(UnitSceneList, HoldsAtLeastFortyScenes) { EXPECT_GE(unit_scene_names().size(), 40U); }

}  // namespace
}  // namespace ptm::testbench
