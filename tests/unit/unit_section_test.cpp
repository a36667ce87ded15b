#include "testbench/run/unit_section.h"

#include <numeric>

#include "testbench/run/unit_probe.h"
#include "tests/golden/made_scene.h"

namespace ptm::testbench {
namespace {

using pipeline::Cycle;
using reference::UnitCounter;

UnitTimed made_timed(const std::string& model) {
  UnitTimed timed{model, 0.5, {}};
  for (Cycle frame = 0; frame < 2; ++frame) {
    pipeline::UnitFrameResult result;
    result.taken = {30 + frame, 31, 40, 95};
    result.answered = {10, 11, 90, 200};
    std::iota(result.counters.value.begin(), result.counters.value.end(), 100 * frame);
    timed.frames.push_back(result);
  }
  return timed;
}

TEST(LatePixels, AreThoseInOtherCyclesOfTheirFrame) {
  const UnitTimed exact = made_timed("pipeline");
  UnitTimed rtl = made_timed("rtl");
  EXPECT_EQ(count_late_pixels(exact, rtl), 0U);
  rtl.frames[1].taken[2] += 1;
  EXPECT_EQ(count_late_pixels(exact, rtl), 1U);
  rtl.frames[0].taken[0] -= 1;
  EXPECT_EQ(count_late_pixels(exact, rtl), 2U);
  EXPECT_EQ(count_late_pixels(rtl, exact), 2U);
}

TEST(LatePixels, AreAllThatOneModelLacks) {
  const UnitTimed exact = made_timed("pipeline");
  UnitTimed rtl = made_timed("rtl");
  rtl.frames[0].taken.pop_back();
  EXPECT_EQ(count_late_pixels(exact, rtl), 1U);
  rtl.frames.pop_back();
  EXPECT_EQ(count_late_pixels(exact, rtl), 5U);
  EXPECT_EQ(count_late_pixels(rtl, exact), 5U);
}

TEST(DifferingCounters, NameEachThatDiffersInAnyFrameOnce) {
  const UnitTimed exact = made_timed("pipeline");
  EXPECT_EQ(differing_counters(exact, exact), std::vector<std::string>{});
  for (std::size_t i = 0; i < reference::kUnitCounters; ++i) {
    UnitTimed rtl = made_timed("rtl");
    rtl.frames[0].counters.value[i] += 1;
    rtl.frames[1].counters.value[i] -= 1;  // the sums agree
    EXPECT_EQ(differing_counters(exact, rtl),
              std::vector{std::string(reference::unit_counter_names()[i])});
  }
}

TEST(DifferingCounters, TellOfAFrameThatIsMissing) {
  const UnitTimed exact = made_timed("pipeline");
  UnitTimed rtl = made_timed("rtl");
  rtl.frames.pop_back();
  EXPECT_EQ(differing_counters(exact, rtl).size(), reference::kUnitCounters);
  EXPECT_EQ(differing_counters(rtl, exact).size(), reference::kUnitCounters);
}

class UnitSectionOfAScene : public golden::MadeScene {
 protected:
  [[nodiscard]] UnitJob job(const std::string& hardware, const std::string& texture = "") const {
    return make_unit_job(
        read("[image]\nsize = [6, 6]\n[[texture]]\nname = \"m\"\n"
             "generate = \"noise\"\nsize = [16, 16]\n" +
             texture +
             "[[object]]\nkind = \"plane\"\ntexture = \"m\"\n[[object]]\nkind = "
             "\"plane\"\ntexture = \"m\"\ncolor = \"c\"\ntranslate = [0, 9, 0]\n"
             "[[texture]]\nname = \"c\"\ngenerate = \"noise\"\n"
             "kind = \"picture\"\n" +
             "[[light]]\ndirection = [0, -3, 4]\n" + hardware));
  }
};

TEST_F(UnitSectionOfAScene, CountsWarmCyclesByBeatsAndPasses) {
  EXPECT_EQ(warm_cycles_per_pixel(job("[hardware]\ntmus = 3\n"), 0), 1);
  EXPECT_EQ(warm_cycles_per_pixel(job("[hardware]\ntmus = 2\n"), 0), 2);
  EXPECT_EQ(warm_cycles_per_pixel(job("[hardware]\ntmus = 1\n"), 0), 3);
  const std::string rgb = "kind = \"rgb\"\n";
  EXPECT_EQ(warm_cycles_per_pixel(job("[hardware]\ntmus = 3\n", rgb), 0), 3)
      << "two beats, but three passes of the evaluator";
  EXPECT_EQ(warm_cycles_per_pixel(job("[hardware]\ntmus = 1\n", rgb), 0), 6);
  EXPECT_EQ(warm_cycles_per_pixel(job("[hardware]\neval_lanes = 3\n", rgb), 0), 2)
      << "three evaluators take the passes at once";
  EXPECT_EQ(warm_cycles_per_pixel(job("[hardware]\ntmus = 3\n"), 1), 0) << "no pixel is of it";
}

TEST_F(UnitSectionOfAScene, MeansWarmCyclesOverProbesAndFootprints) {
  UnitJob made = job("", "filter = \"trilinear\"\n");
  auto& fragments = made.frames.front().fragments;
  ASSERT_GE(fragments.size(), 3U);
  fragments.resize(3);
  for (auto& fragment : fragments) fragment.lod = 256, fragment.probes_log2 = 0;
  EXPECT_EQ(warm_cycles_per_pixel(made, 0), 1) << "a whole level: one footprint";
  fragments[1].lod = 256 + 128;
  EXPECT_DOUBLE_EQ(warm_cycles_per_pixel(made, 0), (1 + 2 + 1) / 3.0);
  fragments[2].probes_log2 = 2;
  EXPECT_DOUBLE_EQ(warm_cycles_per_pixel(made, 0), (1 + 2 + 4) / 3.0);
}

TEST_F(UnitSectionOfAScene, SaysWhatDiffersAndWhenLinesCame) {
  const UnitJob made = job("");
  std::vector<UnitTimed> timed{made_timed("pipeline"), made_timed("rtl")};
  timed[1].frames[1].taken[3] = 96;
  timed[1].frames[1].counters[UnitCounter::tag_hits] += 7;
  const UnitSection section = make_unit_section(made, timed);
  EXPECT_EQ(section.late_pixels, 1U);
  EXPECT_EQ(section.differing_counters, std::vector<std::string>{"tag_hits"});
  ASSERT_EQ(section.draws.size(), 2U);
  EXPECT_EQ(section.draws[1].texture + section.draws[1].color, "mc");
  const auto& lines = section.timings[0].lines_per_window;
  EXPECT_EQ(std::accumulate(lines.begin(), lines.end(), 0U), 6U)
      << "a line that comes after the last pixel is in no window";
  EXPECT_EQ(make_unit_section(made, {timed[0]}).late_pixels, 0U);
}

TEST_F(UnitSectionOfAScene, ProbesAPixelOfAFrameThatAFaultKeptFromBeingDrawn) {
  const auto made = std::make_shared<const UnitJob>(job(""));
  ASSERT_FALSE(made->frames.front().samples.empty());
  const golden::SurfaceSample& seen = made->frames.front().samples.front();
  const PixelProbe probe = make_unit_probe(made, {UnitTimed{"rtl", 0, {}}});
  const auto values = probe("rtl", 0, seen.x, seen.y);
  EXPECT_FALSE(values.empty());
  for (const NamedValue& value : values) EXPECT_NE(value.name, "leaves in cycle");
}

}  // namespace
}  // namespace ptm::testbench
