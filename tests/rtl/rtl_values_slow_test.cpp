// Ten million vectors a preset (issue: 0 differences between reference and RTL).
#include <gtest/gtest.h>

#include "tests/rtl/rtl_checks.h"

namespace ptm::testbench {
namespace {

class RtlValuesSlow : public testing::TestWithParam<RtlVariant> {};

TEST_P(RtlValuesSlow, EqualTheReferenceOnTenMillionLrgbVectors) {
  const auto rtl = GetParam().make();
  const pipeline::StreamTiming timing{.seed = 11, .input_gap = 0.05, .output_stall = 0.05};
  EXPECT_GT(check_lrgb(GetParam(), *rtl, 10, 10'000'000, timing), 1'000'000U);
}

TEST_P(RtlValuesSlow, EqualTheReferenceOnTwoMillionRgbVectors) {
  const auto rtl = GetParam().make();
  check_rgb(GetParam(), *rtl, 12, 2'000'000, {.seed = 13, .input_gap = 0, .output_stall = 0.1});
}

INSTANTIATE_TEST_SUITE_P(Variants, RtlValuesSlow, testing::ValuesIn(rtl_variants()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::testbench
