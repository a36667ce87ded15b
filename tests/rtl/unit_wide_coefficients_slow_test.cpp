// Units whose words hold two coefficients, built when first asked for: one and two TMUs, every part
// that effects need, the narrowest such coefficient. docs/spec/unit.md and effects.md, Words.
#include "tests/rtl/exact_frames.h"

namespace ptm::tests {
namespace {

struct WideUnit {
  const char* name;
  reference::EvalConfig config;
  reference::UnitConfig unit;
};

const std::array<WideUnit, 3> kUnits{
    {{"ElevenBitsOneTmuAndEffects",
      {.coef_bits = 11,
       .delta_bits = 12,
       .rounding = reference::Rounding::truncate,
       .lum_frac = 4,
       .filter_frac = 1},
      {.tmus = 1,
       .cache_kib = 1,
       .ways = 1,
       .fragment_fifo = 8,
       .miss_fifo = 13,
       .palette_lrgb_ports = 2,
       .palette_rgb_ports = 2,
       .eval_lanes = 3,
       .extra_sets = 4,
       .extra_passes = 4,
       .half_vector = true,
       .stages = reference::effects::kStages}},
     {"TwelveBitsTwoTmus", {.coef_bits = 12, .delta_bits = 13}, {.tmus = 2, .cache_kib = 2}},
     {"TwelveBitsThreeTmusAndSets",
      {.coef_bits = 12, .delta_bits = 10, .shift_groups = 3},
      {.cache_kib = 4, .extra_sets = 2, .extra_passes = 3}}}};

/// The unit of the test's parameter as a variant: `make` cannot capture, and so stands alone.
const WideUnit* chosen = nullptr;
testbench::RtlUnitVariant variant_of(const WideUnit& wide) {
  chosen = &wide;
  return {wide.name, wide.config, wide.unit,
          [] { return testbench::make_rtl_unit(chosen->config, chosen->unit); }};
}

class SlowWideCoefficients : public testing::TestWithParam<std::tuple<std::size_t, int>> {};

TEST_P(SlowWideCoefficients, HaveTheCycleAndTheValueOfEveryPixelAndEveryCounter) {
  const auto [number, seed] = GetParam();
  const WideUnit& wide = kUnits[number];
  UnitSceneMaker make(static_cast<std::uint64_t>(seed));
  UnitScene scene = make.scene(wide.config, wide.unit);
  spread_luminance(scene);
  auto fragments = random_fragments(make, scene, 1000);
  for (std::size_t n = 0; n < fragments.size(); ++n) {
    fragments[n].draw = static_cast<std::uint8_t>(n / 50 % scene.state.draws.size());
  }
  expect_same_frames(variant_of(wide),
                     {"Random",
                      pipeline::RandomMemory{.seed = 3, .latency_max = 60},
                      {.seed = 3, .input_gap = 0.2, .output_stall = 0.2}},
                     scene, fragments);
}

INSTANTIATE_TEST_SUITE_P(Units, SlowWideCoefficients,
                         testing::Combine(testing::Range(std::size_t{0}, kUnits.size()),
                                          testing::Range(1, 5)),
                         [](const auto& tested) {
                           return std::string(kUnits[std::get<0>(tested.param)].name) + "Scene" +
                                  std::to_string(std::get<1>(tested.param));
                         });

}  // namespace
}  // namespace ptm::tests
