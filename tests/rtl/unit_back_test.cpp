// The back of the texture unit in RTL: values against the reference, cycles against the contract.
#include <gtest/gtest.h>

#include "tests/reference/unit_scene.h"
#include "tests/rtl/unit_back_schedule.h"
#include "tests/rtl/unit_back_variants.h"

namespace ptm::tests {
namespace {

using reference::Draw;
using reference::TextureFormat;
using reference::UnitCounter;
using reference::UnitFragment;
using reference::UnitPixel;

/// A hash of (seed, cycle) as a number in 0..99.
unsigned percent(std::uint64_t seed, std::uint64_t cycle) {
  std::uint64_t x = (seed * 0x9E3779B97F4A7C15ULL) ^ ((cycle + 1) * 0xBF58476D1CE4E5B9ULL);
  x = (x ^ (x >> 29)) * 0x94D049BB133111EBULL;
  return static_cast<unsigned>((x >> 33) % 100);
}

/// What a run is offered and how its output is taken.
struct Traffic {
  std::uint64_t seed = 0;
  unsigned gap = 0, stall = 0;  ///< percent of cycles without a new beat; with the output blocked
};

template <class Variant>
class UnitBackTest : public testing::Test {
 protected:
  UnitScene scene(std::uint64_t seed) {
    UnitSceneMaker maker(seed);
    UnitScene made = maker.scene(Variant::config);
    if (Variant::config.shift_groups == 3) {
      for (Draw& draw : made.state.draws) {
        draw.shift[1] = draw.shift[2] = draw.shift[0];
        draw.shift[4] = draw.shift[3];
      }
    }
    return made;
  }

  /// Fragments through the RTL: every pixel the reference's, every beat and every pixel in its
  /// cycle, every increment the reference's count.
  void run(const UnitScene& scene, const std::vector<UnitFragment>& fragments,
           const Traffic& traffic) {
    std::vector<BackBeat> beats;
    reference::UnitCounters expected;
    for (const UnitFragment& f : fragments) {
      const std::vector<BackBeat> more = back_beats(scene.state, Variant::unit, f);
      beats.insert(beats.end(), more.begin(), more.end());
      count_fragment(scene.state.draws[f.draw], f, Variant::unit, expected);
    }
    const auto ready = [&](std::uint64_t c) { return percent(traffic.seed, c) >= traffic.stall; };
    BackSchedule schedule(Variant::unit, ready);
    std::size_t sent = 0, taken = 0;
    std::uint64_t in_d = 0, leaves = 0;
    bool occupied = false;
    for (std::uint64_t cycle = 10; taken < fragments.size(); ++cycle) {
      ASSERT_LT(cycle, 200 * (beats.size() + 1)) << "the unit hangs";
      if (!occupied && sent < beats.size() &&
          percent(traffic.seed + 1, cycle) >= traffic.gap) {
        occupied = true;
        in_d = cycle;
        leaves = schedule.beat(scene.state.draws[beats[sent].fragment.draw], beats[sent], in_d);
      }
      const BackCycle seen = bench_.cycle(occupied ? &beats[sent] : nullptr, ready(cycle));
      ASSERT_EQ(seen.left, occupied && cycle == leaves)
          << "beat " << sent << " in D since " << in_d << ", cycle " << cycle << ", expected to "
          << "leave in " << leaves;
      if (seen.left) {
        occupied = false;
        ++sent;
      }
      if (!seen.taken) continue;
      ASSERT_LT(taken, schedule.pixels().size()) << "a pixel before its beats, cycle " << cycle;
      ASSERT_EQ(cycle, schedule.pixels()[taken]) << "pixel " << taken;
      const UnitFragment& f = fragments[taken];
      const UnitPixel pixel = reference::shade(scene.config, scene.state, f);
      ASSERT_EQ(seen.pixel, pixel)
          << "pixel " << taken << ", format "
          << static_cast<int>(scene.state.draws[f.draw].format) << ", combine "
          << static_cast<int>(scene.state.draws[f.draw].combine) << ": " << describe(f);
      ++taken;
    }
    for (int n = 0; n < 40; ++n) ASSERT_FALSE(bench_.cycle(nullptr, true).offered) << "too many";
    EXPECT_EQ(bench_.counts.palette, expected[UnitCounter::palette_lookups]);
    EXPECT_EQ(bench_.counts.filter, expected[UnitCounter::multiplies_filter]);
    EXPECT_EQ(bench_.counts.eval, expected[UnitCounter::multiplies_eval]);
    EXPECT_EQ(bench_.counts.combine, expected[UnitCounter::multiplies_combine]);
  }

  UnitBack<typename Variant::Dut> bench_;
};

using Variants = testing::Types<BackDefault, BackCorner, BackNarrow>;
TYPED_TEST_SUITE(UnitBackTest, Variants);

TYPED_TEST(UnitBackTest, EqualsTheReferenceAndItsCyclesOnRandomScenes) {
  std::array<int, 5> formats{};
  std::array<int, 6> combines{};
  std::array<int, 8> cases{};  // split, not lit, two footprints, of one texture only, probes, ...
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    UnitSceneMaker maker(seed);
    const UnitScene scene = this->scene(seed);
    this->bench_.reset();
    this->bench_.load(scene.state);
    ASSERT_FALSE(this->bench_.dut.error_o);
    std::vector<UnitFragment> fragments;
    for (int n = 0; n < 300; ++n) {
      UnitFragment f = maker.fragment(scene);
      const int light = 1 << (TypeParam::config.light_int + TypeParam::config.light_frac - 1);
      f.lu = maker.in(-light, light - 1);
      f.lv = maker.in(-light, light - 1);
      fragments.push_back(f);
      const Draw& draw = scene.state.draws[f.draw];
      ++formats[static_cast<std::size_t>(draw.format)];
      ++combines[static_cast<std::size_t>(draw.combine)];
      const int map_f = reference::choose_level(draw, f, 0).weight;
      const int color_f = reference::choose_level(draw, f, 1).weight;
      cases[0] += !f.lit;
      cases[1] += map_f != 0 && color_f != 0;
      cases[2] += map_f == 0 && color_f != 0;
      cases[3] += map_f != 0 && color_f == 0 && draw.color;
      cases[4] += f.probes_log2 != 0;
      for (const BackBeat& beat : back_beats(scene.state, TypeParam::unit, f)) {
        cases[5] += !beat.sub_last;
      }
    }
    const unsigned gap = seed % 3 == 0 ? 0 : 40, stall = seed % 2 == 0 ? 0 : 60;
    this->run(scene, fragments, {seed, gap, stall});
    if (this->HasFatalFailure()) {
      ADD_FAILURE() << "seed " << seed;
      return;
    }
  }
  for (const int count : formats) EXPECT_GT(count, 100);
  for (const int count : combines) EXPECT_GT(count, 50);
  for (unsigned n = 0; n < 6; ++n) EXPECT_GT(cases[n], 25) << "case " << n;
}

}  // namespace
}  // namespace ptm::tests
