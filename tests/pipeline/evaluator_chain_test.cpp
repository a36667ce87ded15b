// Reference, RTL and pipeline on the same operands, equal in every value and every cycle.
#include "tests/pipeline/compare_three.h"

namespace ptm {
namespace {

constexpr std::array<pipeline::StreamTiming, 5> kTimings{
    {{1, 0, 0}, {2, 0.4, 0}, {3, 0, 0.6}, {4, 0.3, 0.3}, {5, 0.1, 0.9}}};

class EvaluatorChain
    : public testing::TestWithParam<std::tuple<reference::Preset, pipeline::StreamTiming>> {};

TEST_P(EvaluatorChain, OfReferenceRtlAndPipelineAgreesInLrgbPixelsAndCycles) {
  const auto& [preset, timing] = GetParam();
  tests::expect_none(tests::compare_lrgb(preset, 40000, 11 + timing.seed, timing));
}

TEST_P(EvaluatorChain, OfReferenceRtlAndPipelineAgreesInRgbPixelsAndCycles) {
  const auto& [preset, timing] = GetParam();
  tests::expect_none(tests::compare_rgb(preset, 40000, 17 + timing.seed, timing));
}

std::string name_of(const testing::TestParamInfo<EvaluatorChain::ParamType>& chain) {
  return std::string(std::get<0>(chain.param).name) + "_timing" +
         std::to_string(std::get<1>(chain.param).seed);
}

INSTANTIATE_TEST_SUITE_P(Presets, EvaluatorChain,
                         testing::Combine(testing::ValuesIn(reference::kPresets),
                                          testing::ValuesIn(kTimings)),
                         name_of);

TEST(EvaluatorChain, WithASlowSourceStillAgreesInEveryCycle) {
  const pipeline::StreamTiming timing{.seed = 6, .output_stall = 0.2, .idle = 3, .group = 3};
  tests::expect_none(tests::compare_rgb(reference::kPresets[1], 20000, 1, timing));
}

}  // namespace
}  // namespace ptm
