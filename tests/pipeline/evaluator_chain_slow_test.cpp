// Ten million vectors a preset through reference, RTL and pipeline.
#include "tests/pipeline/compare_three.h"

namespace ptm {
namespace {

class TenMillionVectors : public testing::TestWithParam<reference::Preset> {};

TEST_P(TenMillionVectors, AgreeInEveryLrgbPixelAndCycle) {
  tests::expect_none(tests::compare_lrgb(GetParam(), 10'000'000, 20261122, {7, 0.1, 0.1}));
}

TEST_P(TenMillionVectors, AgreeInEveryRgbPixelAndCycle) {
  tests::expect_none(tests::compare_rgb(GetParam(), 10'000'000, 20261123, {8, 0.1, 0.1}));
}

INSTANTIATE_TEST_SUITE_P(Presets, TenMillionVectors, testing::ValuesIn(reference::kPresets),
                         [](const auto& preset) { return std::string(preset.param.name); });

}  // namespace
}  // namespace ptm
