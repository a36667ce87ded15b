// The back of the texture unit in RTL: values against the reference, cycles against the contract.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

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
class RtlUnitBack : public testing::Test {
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
      if (!occupied && sent < beats.size() && percent(traffic.seed + 1, cycle) >= traffic.gap) {
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
          << "pixel " << taken << ", format " << static_cast<int>(scene.state.draws[f.draw].format)
          << ", combine " << static_cast<int>(scene.state.draws[f.draw].combine) << ": "
          << describe(f);
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
TYPED_TEST_SUITE(RtlUnitBack, Variants);

TYPED_TEST(RtlUnitBack, EqualsTheReferenceAndItsCyclesOnRandomScenes) {
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

/// Palettised fragments, of four taps or one, split by seams or not, with plain ones among them.
template <class Variant>
std::vector<UnitFragment> mostly_palettised(UnitSceneMaker& maker, const UnitScene& scene,
                                            std::size_t count) {
  std::vector<UnitFragment> out;
  while (out.size() < count) {
    UnitFragment f = maker.fragment(scene);
    const TextureFormat format = scene.state.draws[f.draw].format;
    const bool palette =
        format == TextureFormat::palette_lrgb || format == TextureFormat::palette_rgb;
    if (!palette && maker.in(0, 4) != 0) continue;
    const int light = 1 << (Variant::config.light_int + Variant::config.light_frac - 1);
    f.lu = maker.in(-light, light - 1);
    f.lv = maker.in(-light, light - 1);
    out.push_back(f);
  }
  return out;
}

/// Whether a draw of the scene is palettised.
bool has_palette(const UnitScene& scene) {
  return std::ranges::any_of(scene.state.draws, [](const Draw& draw) {
    return draw.format == TextureFormat::palette_lrgb || draw.format == TextureFormat::palette_rgb;
  });
}

TYPED_TEST(RtlUnitBack, PalettisedBeatsKeepValuesAndCyclesAmongPlainOnes) {
  std::map<std::uint64_t, int> look_ups;  // of how many cycles, beats of how many
  int parts = 0;
  int scenes = 0;
  for (std::uint64_t seed = 100; scenes < 8; ++seed) {
    UnitSceneMaker maker(seed);
    const UnitScene scene = this->scene(seed);
    if (!has_palette(scene)) continue;
    this->bench_.reset();
    this->bench_.load(scene.state);
    const auto fragments = mostly_palettised<TypeParam>(maker, scene, 150);
    for (const UnitFragment& f : fragments) {
      for (const BackBeat& beat : back_beats(scene.state, TypeParam::unit, f)) {
        ++look_ups[look_up_cycles(TypeParam::unit, scene.state.draws[f.draw], beat)];
        parts += !beat.sub_last;
      }
    }
    const unsigned gap = scenes % 2 == 0 ? 0 : 50;
    const unsigned stall = std::array{0U, 40U, 70U, 90U}[static_cast<std::size_t>(scenes) / 2];
    this->run(scene, fragments, {seed, gap, stall});
    if (this->HasFatalFailure()) {
      ADD_FAILURE() << "seed " << seed;
      return;
    }
    ++scenes;
  }
  const int ports = std::min(TypeParam::unit.palette_lrgb_ports, TypeParam::unit.palette_rgb_ports);
  for (int cycles = 1; cycles <= 4 / ports; cycles *= 2) {  // a footprint has 1, 2 or 4 taps
    EXPECT_GT(look_ups[static_cast<std::uint64_t>(cycles)], 30) << cycles << " look-up cycles";
  }
  EXPECT_GT(parts, 30);
}

TYPED_TEST(RtlUnitBack, AResetAmidLookUpsLeavesNothingBehind) {
  std::uint64_t seed = 200;
  while (!has_palette(this->scene(seed))) ++seed;
  UnitSceneMaker maker(seed);
  const UnitScene scene = this->scene(seed);
  this->bench_.reset();
  this->bench_.load(scene.state);
  for (std::size_t moment = 1; moment < 48; moment += moment < 12 ? 1 : 5) {
    SCOPED_TRACE("a reset after " + std::to_string(moment) + " cycles");
    const auto lost = mostly_palettised<TypeParam>(maker, scene, moment);
    std::size_t cycle = 0;
    for (const UnitFragment& f : lost) {
      for (const BackBeat& beat : back_beats(scene.state, TypeParam::unit, f)) {
        while (cycle < moment && !this->bench_.cycle(&beat, cycle % 3 == 0).left) ++cycle;
        ++cycle;
        if (cycle >= moment) break;
      }
      if (cycle >= moment) break;
    }
    this->bench_.reset();
    this->bench_.load_draws(scene.state);
    this->run(scene, mostly_palettised<TypeParam>(maker, scene, 12), {moment, 0, 50});
    if (this->HasFatalFailure()) return;
  }
}

/// One draw of one format, its textures of 4 x 4 texels.
template <class Variant>
class RtlUnitBackTiming : public RtlUnitBack<Variant> {
 protected:
  void load(TextureFormat format, bool color = false) {
    reference::UnitState& state = scene_.state;
    scene_ = UnitSceneMaker(3).scene(Variant::config, 1);
    state.memory.clear();
    Draw draw;
    draw.format = format;
    draw.color = color || format == TextureFormat::none;
    draw.combine = draw.color ? reference::Combine::replace : reference::Combine::none;
    const bool rgb = format == TextureFormat::rgb || format == TextureFormat::palette_rgb;
    if (format == TextureFormat::lrgb || format == TextureFormat::rgb) {
      const reference::StoredTexture map{4,
                                         4,
                                         rgb,
                                         std::vector<std::uint16_t>(rgb ? 288 : 96, 7),
                                         std::vector<std::uint8_t>(rgb ? 0 : 48, 200),
                                         {},
                                         {}};
      draw.map = append_map(Variant::config, std::span(&map, 1), state.memory);
    } else if (format != TextureFormat::none) {
      const reference::StoredPaletteMap map{4, 4, rgb, std::vector<std::uint16_t>(16, 5),
                                            std::vector<std::uint8_t>(rgb ? 0 : 48, 200)};
      draw.map = append_palette_map(std::span(&map, 1), state.memory);
    }
    if (draw.color) {
      const reference::StoredPicture picture{4, 4, std::vector<std::uint8_t>(64, 90)};
      draw.color_texture = append_picture(std::span(&picture, 1), state.memory);
    }
    state.draws = {draw};
    this->bench_.reset();
    this->bench_.load(state);
  }
  /// In the middle of four texels (all four taps), or in the middle of one.
  [[nodiscard]] static UnitFragment at(bool four) {
    UnitFragment f;
    f.u = f.v = four ? 1 << 19 : 3 << 17;
    return f;
  }
  [[nodiscard]] std::vector<BackBeat> beats(const UnitFragment& f) const {
    return back_beats(scene_.state, Variant::unit, f);
  }
  /// Beats accepted out of D, one offered in every cycle, while the output is blocked.
  int accepted_while_blocked(const std::vector<BackBeat>& cycle_of_beats) {
    int accepted = 0;
    for (int n = 0; n < 200; ++n) {
      const auto next = static_cast<std::size_t>(accepted) % cycle_of_beats.size();
      accepted += this->bench_.cycle(&cycle_of_beats[next], false).left;
    }
    return accepted;
  }
  UnitScene scene_;
};
TYPED_TEST_SUITE(RtlUnitBackTiming, Variants);
using RtlUnitBackDefault = RtlUnitBackTiming<BackDefault>;
using RtlUnitBackCorner = RtlUnitBackTiming<BackCorner>;

TEST_F(RtlUnitBackDefault, APixelIsOfferedSixteenCyclesAfterItsOnlyBeatLeftD) {
  load(TextureFormat::lrgb);
  const std::vector<BackBeat> one = beats(at(true));
  ASSERT_EQ(one.size(), 1U);
  ASSERT_TRUE(bench_.cycle(one.data(), false).left);
  for (int cycle = 1; cycle < 16; ++cycle) {
    ASSERT_FALSE(bench_.cycle(nullptr, false).offered) << "cycle " << cycle;
  }
  EXPECT_TRUE(bench_.cycle(nullptr, false).offered);
}

TEST_F(RtlUnitBackDefault, ExactlySeventeenFragmentsOfOneBeatLeaveDWhileTheOutputIsBlocked) {
  load(TextureFormat::lrgb);
  EXPECT_EQ(accepted_while_blocked(beats(at(true))), 6 + 7 + 2 + 2);
}

/// Six words on three TMUs: two beats a fragment. Two pixels stand in C1 and C2, two in the FIFO;
/// the passes of three fragments fill the assembly register and R1 to R7; one fragment is in O, one
/// in L3 (its first beat went to the accumulators); L2, L1, P and Q hold a beat each.
TEST_F(RtlUnitBackDefault, OfAnRgbMapExactlyTwentyTwoBeatsLeaveDWhileTheOutputIsBlocked) {
  load(TextureFormat::rgb);
  const std::vector<BackBeat> two = beats(at(true));
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(accepted_while_blocked(two), 2 * (2 + 2 + 3 + 1 + 1) + 4);
}

TEST_F(RtlUnitBackDefault, AFullUnitGoesOnInTheCycleAfterTheEvaluatorsFifoLetsAPixelGo) {
  load(TextureFormat::lrgb);
  const std::vector<BackBeat> one = beats(at(true));
  accepted_while_blocked(one);
  // C2 to C1 to the FIFO in the cycle of the first pixel; the FIFO accepts in the next one.
  EXPECT_FALSE(bench_.cycle(one.data(), true).left);
  for (int n = 0; n < 20; ++n) {
    const BackCycle seen = bench_.cycle(one.data(), true);
    EXPECT_TRUE(seen.left && seen.taken) << n;
  }
}

TEST_F(RtlUnitBackDefault, AFullPipeGivesAPixelACycleAndThreePassesTakeThree) {
  for (const auto& [format, cycles] :
       {std::pair{TextureFormat::lrgb, 1}, std::pair{TextureFormat::none, 1},
        std::pair{TextureFormat::palette_lrgb, 1}, std::pair{TextureFormat::rgb, 3}}) {
    load(format);
    const std::vector<BackBeat> own = beats(at(true));
    int taken = 0;
    std::size_t sent = 0;
    for (int n = 0; n < 100 + 300; ++n) {
      const BackCycle seen = bench_.cycle(&own[sent % own.size()], true);
      sent += seen.left;
      if (n >= 100) taken += seen.taken;
    }
    EXPECT_EQ(taken, 300 / cycles) << static_cast<int>(format);
  }
}

/// Cycles in which a lone beat stands in D.
template <class Bench>
int cycles_in_d(Bench& bench, const BackBeat& beat, bool ready = true) {
  int cycles = 1;
  while (!bench.cycle(&beat, ready).left && cycles < 20) ++cycles;
  return cycles;
}

/// The unit is full of beats of one kind; then its output is free.
TYPED_TEST(RtlUnitBackTiming, ABeatInDHasItsLookUpCyclesOnceABlockedQIsEmptied) {
  for (const TextureFormat format : {TextureFormat::palette_lrgb, TextureFormat::palette_rgb}) {
    for (const unsigned taps : {0b0001U, 0b1010U, 0b0111U, 0b1111U}) {
      this->load(format);
      const BackBeat whole = this->beats(this->at(true))[0];
      BackBeat waiting = whole;
      waiting.taps[0] = taps;
      const std::uint64_t look_ups =
          look_up_cycles(TypeParam::unit, this->scene_.state.draws[0], waiting);
      SCOPED_TRACE(std::to_string(look_ups) + " look-up cycles, format " +
                   std::to_string(static_cast<int>(format)));
      this->accepted_while_blocked({whole});
      // However long it stands before a full Q, it has had none.
      for (int n = 0; n < 10; ++n) ASSERT_FALSE(this->bench_.cycle(&waiting, false).left);
      std::uint64_t emptied = 0, left = 0;
      // A beat of one look-up cycle, in a unit in the same state, leaves in the cycle in which Q is
      // emptied.
      while (!this->bench_.cycle(&waiting, true).left && left < 100) ++left;
      this->load(format);
      this->accepted_while_blocked({whole});
      BackBeat quick = whole;
      quick.taps[0] = 0b0001;
      for (int n = 0; n < 10; ++n) ASSERT_FALSE(this->bench_.cycle(&quick, false).left);
      while (!this->bench_.cycle(&quick, true).left && emptied < 100) ++emptied;
      EXPECT_EQ(left, emptied + look_ups - 1);
    }
  }
}

TEST_F(RtlUnitBackDefault, APaletteTakesItsTapsByItsPortsAtATimeOutOfD) {
  load(TextureFormat::palette_lrgb);  // four ports
  EXPECT_EQ(cycles_in_d(bench_, beats(at(true))[0]), 1);
  load(TextureFormat::palette_rgb);  // one port
  EXPECT_EQ(cycles_in_d(bench_, beats(at(true))[0]), 4);
  EXPECT_EQ(cycles_in_d(bench_, beats(at(false))[0]), 1);
  BackBeat none = beats(at(true))[0];
  none.taps = {};
  EXPECT_EQ(cycles_in_d(bench_, none), 1);
  EXPECT_EQ(bench_.counts.palette, 4U + 1U);
}

TEST_F(RtlUnitBackCorner, APaletteTakesItsTapsByItsPortsAtATimeOutOfD) {
  load(TextureFormat::palette_lrgb);  // one port
  EXPECT_EQ(cycles_in_d(bench_, beats(at(true))[0]), 4);
  load(TextureFormat::palette_rgb);  // two ports
  EXPECT_EQ(cycles_in_d(bench_, beats(at(true))[0]), 2);
  BackBeat three = beats(at(true))[0];
  three.taps = {0b1101};
  EXPECT_EQ(cycles_in_d(bench_, three), 2);
}

TEST_F(RtlUnitBackDefault, SubBeatsLeaveDWhileQIsEmptyAndWaitWhileItIsNot) {
  load(TextureFormat::palette_rgb);
  const BackBeat whole = beats(at(true))[0];
  const int held = accepted_while_blocked({whole});
  BackBeat part = whole;
  part.sub_last = false;
  part.taps[0] = 0b0101;
  for (int n = 0; n < 20; ++n) EXPECT_FALSE(bench_.cycle(&part, false).left) << "Q is full";
  load(TextureFormat::palette_rgb);
  for (int left = 0; left + 1 < held;) left += bench_.cycle(&whole, false).left;
  for (int n = 0; n < 20; ++n) bench_.cycle(nullptr, false);                   // all but Q are full
  for (int n = 0; n < 3; ++n) EXPECT_EQ(cycles_in_d(bench_, part, false), 2);  // by one port
  part.sub_last = true;
  EXPECT_EQ(cycles_in_d(bench_, part, false), 2);
  for (int n = 0; n < 20; ++n) EXPECT_FALSE(bench_.cycle(&part, false).left);
}

TEST_F(RtlUnitBackDefault, AResetEmptiesEveryStageAndForgetsTheLookUpsOfTheBeatInD) {
  load(TextureFormat::palette_rgb);
  const BackBeat whole = beats(at(true))[0];
  accepted_while_blocked({whole});
  bench_.cycle(&whole, false);
  bench_.reset();
  for (int n = 0; n < 40; ++n) EXPECT_FALSE(bench_.cycle(nullptr, true).offered);
  load(TextureFormat::palette_rgb);
  EXPECT_EQ(cycles_in_d(bench_, whole), 4);
}

}  // namespace
}  // namespace ptm::tests
