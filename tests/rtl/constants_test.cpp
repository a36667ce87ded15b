// The RTL's parameters and derived widths against the reference's, for every variant.
#include <gtest/gtest.h>

#include <vector>

#include "model/reference/eval_widths.h"
#include "testbench/rtl/probe.h"
#include "testbench/rtl/rtl_variants.h"

namespace ptm::testbench {
namespace {

class RtlConstants : public testing::TestWithParam<RtlVariant> {};

/// EvalWidths, member by member in the order of the header.
std::vector<int> flat(const reference::EvalWidths& w) {
  std::vector<int> values{w.stored, w.delta, w.light, w.basis};
  for (const auto& row : {w.product, w.frac, w.pre_shift, w.amount_max}) {
    values.insert(values.end(), row.begin(), row.end());
  }
  for (int value : {w.term, w.sum, w.lum, w.color_product}) values.push_back(value);
  return values;
}

TEST_P(RtlConstants, ParametersAreThoseOfTheConfiguration) {
  const auto rtl = GetParam().make();
  std::uint8_t number = probe::kParameters;
  for (const reference::NamedParameter& parameter : reference::rtl_parameters(GetParam().config)) {
    EXPECT_EQ(rtl->probe(number++), parameter.value) << parameter.name;
  }
}

TEST_P(RtlConstants, DerivedWidthsAreTheReferences) {
  const auto rtl = GetParam().make();
  const std::vector<int> expected = flat(reference::widths(GetParam().config));
  ASSERT_EQ(expected.size(), static_cast<std::size_t>(probe::kWidthCount));
  for (std::uint8_t i = 0; i < probe::kWidthCount; ++i) {
    EXPECT_EQ(rtl->probe(static_cast<std::uint8_t>(probe::kWidths + i)), expected[i])
        << "width number " << int{i};
  }
}

INSTANTIATE_TEST_SUITE_P(Variants, RtlConstants, testing::ValuesIn(rtl_variants()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::testbench
