#include "testbench/plan/scene_plan.h"

#include "model/reference/unit/unit_beats.h"
#include "testbench/run/unit_job.h"
#include "tests/unit/unit_agreement.h"

namespace ptm::testbench {
namespace {

golden::UnitScene read(const std::string& name) {
  return golden::read_unit_scene(std::filesystem::path(PTM_SOURCE_DIR) / "scenes" /
                                 (name + ".toml"));
}

std::vector<std::string> block_names(const ScenePlan& plan) {
  std::vector<std::string> names;
  for (const PlannedBlock& block : plan.blocks) names.push_back(block.name);
  return names;
}

using Names = std::vector<std::string>;

TEST(ScenePlan, BuildsInWhatAnyDrawNeedsAndNothingElse) {
  EXPECT_EQ(block_names(make_scene_plan(read("sphere"))), Names{});
  EXPECT_EQ(make_scene_plan(read("sphere")).unit, reference::UnitConfig{});
  EXPECT_EQ(block_names(make_scene_plan(read("effect_diffuse_gain"))), Names{});
  EXPECT_EQ(block_names(make_scene_plan(read("effect_half_vector"))),
            (Names{"half_vector", "extra_passes", "power", "add"}));
  EXPECT_EQ(block_names(make_scene_plan(read("effect_all"))),
            (Names{"half_vector", "extra_sets", "extra_passes", "power", "modulate", "add"}));
}

TEST(ScenePlan, NamesWhoAsksForABlock) {
  const ScenePlan plan = make_scene_plan(read("effect_all"));
  EXPECT_EQ(plan.blocks[0].effects, (Names{"half-vector", "specular-enhancement"}));
  EXPECT_EQ(plan.blocks[4].effects,
            (Names{"modulated-specular", "off-specular", "fresnel", "anisotropic"}));
}

TEST(ScenePlan, CountsAHighlightAsAPassWithoutAWord) {
  const PlannedDraw plain = make_scene_plan(read("sphere")).draws[0];
  const PlannedDraw draw = make_scene_plan(read("effect_half_vector")).draws[0];
  EXPECT_EQ(draw.words, plain.words);
  EXPECT_EQ(draw.extra_passes, 1);
  EXPECT_EQ(draw.least.cycles, 2);
  EXPECT_EQ(draw.least.eval, 19U) << "eleven, and eight more for the half-vector";
  EXPECT_EQ(draw.least.effects, 1U);
}

/// What is predicted for the least and the most is what the reference's fragments really cost.
class PlannedScenes : public testing::TestWithParam<std::string> {};

TEST_P(PlannedScenes, CostWithinWhatIsPlanned) {
  const UnitJob job = load_unit_scene(GetParam());
  for (const UnitFrameInput& frame : job.frames) {
    for (const reference::UnitFragment& fragment : frame.fragments) {
      const PlannedDraw& planned = job.plan.draws[fragment.draw];
      reference::UnitCounters n;
      count_fragment(job.state.draws[fragment.draw], fragment, job.unit, n, job.config);
      using reference::UnitCounter;
      ASSERT_GE(n[UnitCounter::words], planned.least.words);
      ASSERT_LE(n[UnitCounter::words], planned.most.words);
      ASSERT_LE(n[UnitCounter::taps], planned.most.taps);
      ASSERT_EQ(n[UnitCounter::multiplies_eval], planned.least.eval);
      ASSERT_EQ(n[UnitCounter::multiplies_effects], planned.least.effects);
      ASSERT_EQ(n[UnitCounter::multiplies_combine], planned.least.combine);
      ASSERT_LE(n[UnitCounter::multiplies_filter], planned.most.filter);
      ASSERT_LE(n[UnitCounter::multiplies_address], planned.most.address);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PlannedScenes,
                         testing::Values("sphere", "effect_all", "palette_rgb_probes",
                                         "plane_trilinear", "combine_decal"),
                         [](const auto& scene) { return scene.param; });

/// Cycles of n copies of a fragment, by the timing exact.
std::uint64_t cycles_of(UnitJob job, const reference::UnitFragment& fragment, std::size_t n) {
  job.frames.resize(1);
  job.frames[0].fragments.assign(n, fragment);
  job.timing = {};
  job.scene.draw_twice = false;
  ChildProcess child = start_unit_model(job, "pipeline");
  return total_counters(take_unit_model(child, "pipeline"))[reference::UnitCounter::cycles];
}

class WarmCycles : public testing::TestWithParam<std::string> {};

TEST_P(WarmCycles, AreWhatEachFurtherCopyOfAFragmentCosts) {
  const UnitJob job = load_unit_scene(GetParam());
  constexpr std::size_t kCopies = 50;
  std::vector<bool> tried(job.state.draws.size());
  for (const reference::UnitFragment& fragment : job.frames[0].fragments) {
    const reference::Draw& draw = job.state.draws[fragment.draw];
    reference::UnitCounters n;
    count_fragment(draw, fragment, job.unit, n, job.config);
    if (tried[fragment.draw] || n[reference::UnitCounter::bank_conflicts] > 0) continue;
    tried[fragment.draw] = true;
    const std::uint64_t once = cycles_of(job, fragment, kCopies),
                        twice = cycles_of(job, fragment, 2 * kCopies);
    EXPECT_EQ(twice - once, kCopies * static_cast<std::uint64_t>(
                                          warm_cycles(draw, job.unit, fragment, job.config)))
        << "draw " << int{fragment.draw};
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, WarmCycles,
                         testing::Values("sphere", "effect_all", "effect_fresnel", "palette_rgb",
                                         "palette_lrgb", "palettes_two", "palette_rgb_probes",
                                         "plane_trilinear", "combine_rgb_one_tmu",
                                         "small_unit_rgb"),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace ptm::testbench
