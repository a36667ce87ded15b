// What SystemC elaborates for a unit: nothing that its configuration does not ask for; and what
// the effects' registers and passes add to a fragment's latency and rate.
#include <gtest/gtest.h>

#include "model/pipeline/effects/stages.h"
#include "model/pipeline/elaborated.h"
#include "model/pipeline/simulate_texture_unit.h"
#include "model/pipeline/unit/memory_target.h"
#include "model/pipeline/unit/texture_unit.h"

namespace ptm::pipeline {
namespace {

using namespace reference;

const std::vector<std::string> kWithoutEffects{"unit",           "unit.memory",    "unit.sink",
                                               "unit.combine",   "unit.evaluator", "unit.filter",
                                               "unit.palette",   "unit.fetch",     "unit.commit",
                                               "unit.miss_ring", "unit.tags",      "unit.address"};

Draw plane() {
  Draw draw;
  draw.map = {64, 64, 1, {}};
  return draw;
}

/// A unit with its memory, which answers at once.
struct Bench {
  sc_core::sc_time clock{1, sc_core::SC_NS};
  MemoryTarget memory{"memory", make_memory(FixedMemory{1, 1}), {}, clock};
  TextureUnit unit;

  Bench(const UnitConfig& config, const Draw& draw) : unit("unit", config, {draw}, {}, {}, clock) {
    unit.memory.socket.bind(memory.socket);
  }
  UnitFrameResult run(std::span<const UnitFragment> fragments, bool keep_cache) {
    sc_core::sc_start(sc_core::SC_ZERO_TIME);
    memory.reset();
    return unit.run({fragments, keep_cache}, kPatience).result;
  }
};

TEST(ElaboratedModules, OfAUnitWithoutEffectsAreTheTwelveThatItAlwaysHad) {
  const Bench bench({}, plane());
  EXPECT_EQ(module_names(elaborated(bench.unit)), kWithoutEffects);
}

class ElaboratedStages : public testing::TestWithParam<unsigned> {};

TEST_P(ElaboratedStages, AreOneModuleEachAndNothingElse) {
  const Bench bench({.extra_passes = 2, .half_vector = true, .stages = GetParam()}, plane());
  std::vector<std::string> want = kWithoutEffects;
  auto place = want.begin() + 3;  // behind the sink, the last stage first
  for (const auto& [bit, name] :
       {std::pair{4U, "unit.add_stage"}, {2U, "unit.modulate_stage"}, {1U, "unit.power_stage"}}) {
    if ((GetParam() & bit) != 0) place = want.insert(place, name) + 1;
  }
  EXPECT_EQ(module_names(elaborated(bench.unit)), want);
}

INSTANTIATE_TEST_SUITE_P(Masks, ElaboratedStages, testing::Range(0U, 8U));

/// Everything that is not a module: ports, sockets, processes.
std::vector<Elaborated> others(const std::vector<Elaborated>& all) {
  std::vector<Elaborated> out;
  for (const Elaborated& object : all) {
    if (object.kind != "sc_module") out.push_back(object);
  }
  return out;
}

TEST(ElaboratedStages, BringNoPortNoSocketAndNoProcess) {
  const sc_core::sc_time clock(1, sc_core::SC_NS);
  const auto count = [&](const char* name, unsigned stages) {
    const TextureUnit unit(name, {.stages = stages}, {plane()}, {}, {}, clock);
    const auto all = others(elaborated(unit));
    EXPECT_FALSE(all.empty()) << "the socket of the memory at least";
    for (const Elaborated& object : all) {
      EXPECT_EQ(object.kind.find("process"), std::string::npos) << object.name;
    }
    return all.size();
  };
  EXPECT_EQ(count("with", 7), count("bare", 0));
}

TEST(ElaboratedModules, AreToldBeforeARun) {
  UnitState state;
  state.draws.push_back(plane());
  const std::vector<UnitFragment> fragments(3);
  std::vector<std::string> told;
  std::size_t frames = 0;
  UnitSimulation simulation;
  simulation.unit.stages = 4;
  simulation.state = &state;
  simulation.frames = {1,
                       [&](std::size_t) {
                         EXPECT_FALSE(told.empty());
                         return UnitFrame{fragments};
                       },
                       [&](std::size_t, UnitFrameResult&&) { ++frames; }};
  simulation.elaborated = [&](const std::vector<std::string>& names) { told = names; };
  simulate_texture_unit(simulation);
  EXPECT_EQ(frames, 1U);
  std::vector<std::string> want{"memory"};
  want.insert(want.end(), kWithoutEffects.begin(), kWithoutEffects.end());
  want.insert(want.begin() + 4, "unit.add_stage");
  want.emplace_back("source");
  EXPECT_EQ(told, want);
}

struct Latency {
  unsigned stages;
  int passes;
  Cycle cycles;
};

class EffectLatency : public testing::TestWithParam<Latency> {};

/// Fragments far apart, the same texel: the second and on hit.
TEST_P(EffectLatency, IsThePages25AndOneAPassAndTheChainsRegisters) {
  const Latency c = GetParam();
  Draw draw = plane();
  draw.effects.passes = c.passes;
  draw.effects.stages = c.stages;
  Bench bench({.extra_passes = 4, .stages = c.stages}, draw);
  UnitFragment f;
  f.u = f.v = 3 << 16;
  (void)bench.run(std::vector{f}, false);
  const UnitFrameResult warm = bench.run(std::vector{f}, true);
  EXPECT_EQ(warm.counters[UnitCounter::tag_misses], 0U);
  ASSERT_EQ(warm.taken.size(), 1U);
  EXPECT_EQ(warm.taken[0], c.cycles) << "accepted in cycle 0";
}

INSTANTIATE_TEST_SUITE_P(Built, EffectLatency,
                         testing::Values(Latency{0, 0, 25}, Latency{0, 1, 26}, Latency{0, 4, 29},
                                         Latency{1, 0, 28}, Latency{2, 0, 26}, Latency{4, 0, 26},
                                         Latency{5, 1, 30}, Latency{7, 4, 34}));

struct Rate {
  const char* name;
  TextureFormat format;
  int sets, passes, tmus, lanes;
  Cycle cycles;  ///< a pixel: max(beats, own passes / lanes + extra passes)
};

class EffectRate : public testing::TestWithParam<Rate> {};

TEST_P(EffectRate, IsThePagesWithEveryLineAHit) {
  const Rate c = GetParam();
  Draw draw = plane();
  draw.format = c.format;
  draw.bilinear = false;
  draw.effects.sets = c.sets;
  draw.effects.passes = c.passes;
  for (auto& pass : draw.effects.pass) pass.set = c.sets;
  UnitConfig config{.extra_sets = 4, .extra_passes = 4, .stages = 7};
  config.tmus = c.tmus;
  config.eval_lanes = c.lanes;
  ASSERT_EQ(check_draw(draw, 1 << 20, config), 0U);
  Bench bench(config, draw);
  UnitFragment f;
  f.u = f.v = 3 << 16;
  const std::vector<UnitFragment> fragments(200, f);
  (void)bench.run(fragments, false);
  const UnitFrameResult warm = bench.run(fragments, true);
  ASSERT_EQ(warm.counters[UnitCounter::tag_misses], 0U);
  for (std::size_t n = 50; n < fragments.size(); ++n) {
    ASSERT_EQ(warm.taken[n] - warm.taken[n - 1], c.cycles) << "pixel " << n;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Draws, EffectRate,
    testing::Values(Rate{"LrgbPlain", TextureFormat::lrgb, 0, 0, 3, 1, 1},
                    Rate{"LrgbHalfVector", TextureFormat::lrgb, 0, 1, 3, 1, 2},
                    Rate{"LrgbOneSet", TextureFormat::lrgb, 1, 1, 3, 1, 2},
                    Rate{"LrgbFourSets", TextureFormat::lrgb, 4, 1, 3, 1, 4},
                    Rate{"LrgbFourSetsOneTmu", TextureFormat::lrgb, 4, 4, 1, 1, 11},
                    Rate{"LrgbFourPasses", TextureFormat::lrgb, 0, 4, 3, 1, 5},
                    Rate{"RgbOnePass", TextureFormat::rgb, 1, 1, 3, 1, 4},
                    Rate{"RgbOnePassThreeLanes", TextureFormat::rgb, 1, 1, 3, 3, 3},
                    Rate{"RgbFourPassesThreeLanes", TextureFormat::rgb, 1, 4, 3, 3, 5},
                    Rate{"PaletteOneSet", TextureFormat::palette_rgb, 1, 1, 3, 3, 2}),
    [](const auto& rate) { return std::string(rate.param.name); });

}  // namespace
}  // namespace ptm::pipeline
