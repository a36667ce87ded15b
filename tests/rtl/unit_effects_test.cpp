// What docs/spec/effects.md adds, on the RTL units that have it: values, time, legality.
#include <map>

#include "tests/rtl/unit_runs.h"

namespace ptm::tests {
namespace {

using pipeline::FixedMemory;
using pipeline::RandomMemory;
using reference::UnitFragment;
using reference::UnitState;
using testbench::RtlUnitPins;

/// Draws whose first set lies where others have their colour texture, and is what the power sees.
void show_first_set(UnitScene& scene) {
  for (reference::Draw& draw : scene.state.draws) {
    if (draw.effects.sets == 0) continue;
    draw.color = false;
    draw.combine = reference::Combine::none;
    draw.bilinear = true;
    draw.effects.passes = std::max(draw.effects.passes, 1);
    draw.effects.pass[0] = {1, false};
    draw.effects.stages = scene.unit.stages & 5U;
  }
}

class RtlUnitEffects : public testing::TestWithParam<testbench::RtlUnitVariant> {};

TEST_P(RtlUnitEffects, AreTheReferencesUnderRandomLatenciesStallsAndGaps) {
  const auto& variant = GetParam();
  const auto unit = variant.make();
  std::uint64_t multiplies = 0;
  for (std::uint64_t seed = 101; seed <= 140; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    UnitSceneMaker make(seed);
    UnitScene scene = make.scene(variant.config, variant.unit);
    if (seed % 4 != 0) spread_luminance(scene);
    if (seed % 4 == 1) show_first_set(scene);
    const auto fragments = random_fragments(make, scene, 200);
    unit->load(scene.state);
    const auto memory = make_memory(RandomMemory{.seed = seed, .latency_max = 40});
    const pipeline::StreamTiming timing{.seed = seed,
                                        .input_gap = seed % 3 == 0 ? 0.3 : 0,
                                        .output_stall = seed % 2 == 0 ? 0.3 : 0};
    const auto result = unit->run({.fragments = fragments}, *memory, timing);
    ASSERT_FALSE(result.fault) << result.fault->what;
    expect_pixels(scene, fragments, result.pixels);
    expect_sound(result.counters, fragments.size(), GetParam().unit);
    multiplies += result.counters[UnitCounter::multiplies_effects];
    if (HasFailure()) return;
  }
  EXPECT_EQ(multiplies > 0, (variant.unit.stages & 3U) != 0);
}

TEST_P(RtlUnitEffects, StayWhenTheMemoryMakesRequestsWait) {
  const auto& variant = GetParam();
  const auto unit = variant.make();
  UnitSceneMaker make(99);
  const UnitScene scene = make.scene(variant.config, variant.unit);
  const auto fragments = random_fragments(make, scene, 400);
  unit->load(scene.state);
  unit->stall_requests(0.7, 5);
  const auto memory = make_memory(FixedMemory{.latency = 20, .interval = 1});
  const auto result = unit->run({.fragments = fragments}, *memory, {});
  ASSERT_FALSE(result.fault) << result.fault->what;
  expect_pixels(scene, fragments, result.pixels);
}

/// One point-sampled LRGB texel's draw: one beat with three TMUs, a beat a word with one.
UnitState one_texel(const testbench::RtlUnitVariant& variant, int passes) {
  const reference::StoredTexture map{
      1, 1, false, std::vector<std::uint16_t>(6, 90), std::vector<std::uint8_t>(3, 50), {}, {}};
  UnitState state;
  reference::Draw draw;
  draw.bilinear = false;
  draw.map = append_map(variant.config, std::span(&map, 1), state.memory);
  draw.effects.passes = passes;
  draw.effects.stages = variant.unit.stages;
  state.draws.push_back(draw);
  return state;
}

/// Registers of the stages that the unit has.
std::uint64_t chain_registers(unsigned stages) {
  constexpr std::array<std::uint64_t, 3> kRegisters{3, 1, 1};
  std::uint64_t sum = 0;
  for (unsigned n = 0; n < kRegisters.size(); ++n) sum += (stages >> n & 1U) * kRegisters[n];
  return sum;
}

TEST_P(RtlUnitEffects, TakeACycleAPassAndOneARegisterOfTheChain) {
  const auto& variant = GetParam();
  const auto words = static_cast<std::uint64_t>((3 + variant.unit.tmus - 1) / variant.unit.tmus);
  for (int passes = 0; passes <= variant.unit.extra_passes; ++passes) {
    const UnitState state = one_texel(variant, passes);
    const auto unit = variant.make();
    unit->load(state);
    const auto memory = make_memory(FixedMemory{});
    const std::vector<UnitFragment> fragments(64);
    (void)unit->run({.fragments = fragments}, *memory, {});
    const auto result = unit->run({.fragments = fragments, .keep_cache = true}, *memory, {});
    const auto extra = static_cast<std::uint64_t>(passes);
    const std::uint64_t first = 25 + words - 1 + extra + chain_registers(variant.unit.stages);
    const std::uint64_t rate = std::max(words, 1 + extra);
    for (std::size_t n = 0; n < fragments.size(); ++n) {
      EXPECT_EQ(result.taken[n], first + n * rate) << passes << " passes, pixel " << n;
    }
    EXPECT_EQ(result.counters[UnitCounter::multiplies_eval], (11 + 8 * extra) * fragments.size());
  }
}

TEST_P(RtlUnitEffects, HoldWhatTheUnitHoldsAndAPixelARegisterOfTheChainWhenBlocked) {
  const auto& variant = GetParam();
  if (variant.unit.tmus != 3) return;  // a fragment would not be a beat
  for (const int passes : {0, 1}) {
    const auto unit = variant.make();
    unit->load(one_texel(variant, passes));
    const auto memory = make_memory(FixedMemory{});
    const std::vector<UnitFragment> one(1);
    (void)unit->run({.fragments = one}, *memory, {});
    std::size_t accepted = 0;
    for (int cycle = 0; cycle < 2000; ++cycle) {
      accepted += unit->cycle({.valid = true, .pixel_ready = false}).ready;
    }
    const auto depth = static_cast<std::size_t>(variant.unit.fragment_fifo);
    const std::size_t in_front = depth + 14;  // A0 to A3, T, K, F, D, Q, P, L1, L2, L3, O
    const std::size_t behind = 2 + chain_registers(variant.unit.stages);  // C1, C2
    // The evaluator's nine places begin with a pixel, since an extra pass would be taken. With one
    // extra pass a fragment, five of them are pixels; the last of the four extra passes behind them
    // is that of the fragment in O.
    EXPECT_EQ(accepted, in_front + behind + (passes == 0 ? 9U : 5U)) << passes;
  }
}

/// A descriptor that is wrong in one or more respects, or right.
void break_something(UnitSceneMaker& make, const reference::EvalConfig& config,
                     std::uint64_t memory, reference::Draw& draw) {
  reference::DrawEffects& e = draw.effects;
  switch (make.in(0, 6)) {
    case 0:
      e.sets = make.in(0, 7);
      break;
    case 1:
      e.passes = make.in(0, 7);
      break;
    case 2:
      e.stages = static_cast<unsigned>(make.in(0, 255));
      break;
    case 3:
      e.pass[static_cast<std::size_t>(make.in(0, 3))].set = make.in(0, 7);
      break;
    case 4:
      draw.format = static_cast<reference::TextureFormat>(make.in(0, 4));
      break;
    case 5: {  // a level ends with the memory, or a line behind it
      const int level = make.in(0, draw.map.levels - 1);
      const std::uint64_t lines = level_lines(draw.map, array_planes(draw, config), level);
      draw.map.base[static_cast<std::size_t>(level)] =
          static_cast<std::uint32_t>(memory - lines) + static_cast<std::uint32_t>(make.in(0, 1));
      break;
    }
    default:
      break;
  }
}

/// The draw as the unit's registers hold it: of a part that is not built in, 0.
reference::Draw as_held(reference::Draw draw, const reference::UnitConfig& unit) {
  if (unit.extra_sets == 0) draw.effects.sets = 0;
  if (unit.extra_passes == 0) draw.effects.passes = 0;
  if (unit.stages == 0) draw.effects.stages = 0;
  return draw;
}

TEST_P(RtlUnitEffects, RefuseWhatTheReferenceRefusesWithTheSameBits) {
  const auto& variant = GetParam();
  const auto unit = variant.make();
  std::map<std::uint32_t, int> seen;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    UnitSceneMaker make(seed);
    UnitScene scene = make.scene(variant.config, variant.unit);
    std::uint32_t expected = 0;
    for (std::size_t d = 0; d < scene.state.draws.size(); ++d) {
      break_something(make, variant.config, scene.state.memory.size(), scene.state.draws[d]);
      const unsigned bits = check_draw(as_held(scene.state.draws[d], variant.unit),
                                       scene.state.memory.size(), variant.unit, variant.config);
      expected |= bits << (8 * d);
      ++seen[bits];
    }
    std::uint32_t status = 0;
    try {
      unit->load(scene.state);
    } catch (const testbench::RtlUnitRefusal& refusal) {
      status = refusal.status;
    }
    EXPECT_EQ(status, expected) << "seed " << seed;
  }
  EXPECT_GT(seen[0], 20);
  EXPECT_GT(seen[reference::kBadControl], 20);
  EXPECT_GT(seen[reference::kBadAddress], 3);
}

INSTANTIATE_TEST_SUITE_P(Variants, RtlUnitEffects, testing::ValuesIn(effect_variants()),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// docs/spec/effects.md, Legal: a unit sees what its registers hold.
TEST(RtlUnitWithoutEffects, HoldsNothingInTheirRegistersAndCountsNothing) {
  const auto unit = testbench::make_rtl_unit_base3();
  UnitSceneMaker make(5);
  UnitScene plain = make.scene(reference::kBase);
  const auto fragments = random_fragments(make, plain, 100);
  UnitState with = plain.state;
  for (auto& draw : with.draws) {
    draw.effects.passes = 1;
    draw.effects.pass[0].set = 1;
    draw.effects.sets = 1;
    draw.effects.stages = 7;
  }
  unit->load(with);
  const auto memory = make_memory(FixedMemory{});
  const auto result = unit->run({.fragments = fragments}, *memory, {});
  expect_pixels(plain, fragments, result.pixels);
  EXPECT_EQ(result.counters[UnitCounter::multiplies_effects], 0U);
}

}  // namespace
}  // namespace ptm::tests
