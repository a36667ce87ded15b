// What the RTL computes, against the reference, with zero tolerance.
#include <gtest/gtest.h>

#include <vector>

#include "tests/rtl/rtl_checks.h"

namespace ptm::testbench {
namespace {

using reference::LrgbOperands;
using reference::RgbOperands;
using reference::Value;

constexpr pipeline::StreamTiming kRough{.seed = 7, .input_gap = 0.2, .output_stall = 0.3};

class RtlValues : public testing::TestWithParam<RtlVariant> {};

/// 0, the ends, and where rounding and saturation change, each one step to either side.
std::vector<Value> boundaries(Value low, Value high) {
  std::vector<Value> values{low, low + 1, high - 1, high};
  for (Value near : {low / 2, Value{0}, high / 2}) {
    for (Value step : {-1, 0, 1}) {
      if (near + step >= low && near + step <= high) values.push_back(near + step);
    }
  }
  return values;
}

/// Every pair of light boundaries with every boundary coefficient and shift, one term at a time
/// and all terms alike.
std::vector<LrgbOperands<>> boundary_crossings(const reference::EvalConfig& c) {
  const Value coef_top = (Value{1} << (c.coef_bits + c.filter_frac)) - 1;
  const Value bias_top = (Value{1} << c.coef_bits) - 1;
  const Value light = Value{1} << (c.light_int + c.light_frac - 1);
  const std::vector<Value> coefs{0, 1, coef_top / 2, coef_top / 2 + 1, coef_top};
  const std::vector<Value> biases{0, bias_top / 2 + 1, bias_top};
  const std::vector<Value> shifts{c.shift_min, 0, 1, c.delta_bits, reference::kShiftMax};
  std::vector<LrgbOperands<>> all;
  for (Value lu : boundaries(-light, light - 1)) {
    for (Value lv : boundaries(-light, light - 1)) {
      for (Value coef : coefs) {
        for (Value bias : biases) {
          for (Value shift : shifts) {
            LrgbOperands<> in;
            in.lu = lu;
            in.lv = lv;
            in.bias.fill(bias);
            in.shift.fill(shift);
            in.coef.fill(coef);
            in.rgb = {0, Value{255} << c.filter_frac, Value{1} << c.filter_frac};
            all.push_back(in);
            const auto term = static_cast<unsigned>(all.size() % 6);  // and this one alone
            for (unsigned i = 0; i < 6; ++i) {
              if (i != term) in.coef[i] = std::min(coef_top, bias << c.filter_frac);
            }
            all.push_back(in);
          }
        }
      }
    }
  }
  return all;
}

TEST_P(RtlValues, EqualTheReferenceOnBoundaryCrossings) {
  const auto rtl = GetParam().make();
  const auto operands = boundary_crossings(GetParam().config);
  const RtlRun run = rtl->run(operands, kRough);
  ASSERT_EQ(run.pixels.size(), operands.size());
  Differences differences(GetParam().name);
  for (std::size_t n = 0; n < operands.size(); ++n) {
    differences.expect_equal(run.pixels[n],
                             to_pixel(reference::evaluate_lrgb(GetParam().config, operands[n])), n,
                             [&] { return describe(operands[n]); });
  }
}

TEST_P(RtlValues, EqualTheReferenceOn200000LrgbVectorsUnderGapsAndStalls) {
  const auto rtl = GetParam().make();
  const std::uint64_t within = check_lrgb(GetParam(), *rtl, 1, 200'000, kRough);
  EXPECT_GT(within, 20'000U) << "too few luminances that do not saturate";
}

TEST_P(RtlValues, EqualTheReferenceOn100000RgbVectorsUnderGapsAndStalls) {
  const auto rtl = GetParam().make();
  check_rgb(GetParam(), *rtl, 2, 100'000, kRough);
}

TEST_P(RtlValues, AreTheSameForEveryTiming) {
  const auto rtl = GetParam().make();
  check_lrgb(GetParam(), *rtl, 3, 20'000, {});
  check_lrgb(GetParam(), *rtl, 3, 20'000, {.seed = 3, .input_gap = 0, .output_stall = 0.9});
  check_lrgb(GetParam(), *rtl, 3, 20'000, {.seed = 4, .input_gap = 0.9, .output_stall = 0});
  check_rgb(GetParam(), *rtl, 3, 20'000, {});
  check_rgb(GetParam(), *rtl, 3, 20'000, {.seed = 5, .input_gap = 0, .output_stall = 0.9});
}

/// Every stage register, value by value.
void expect_same_trace(const reference::LuminanceTrace<Value>& rtl,
                       const reference::LuminanceTrace<Value>& expected) {
  EXPECT_EQ(rtl.d, expected.d);
  EXPECT_EQ(rtl.b.uu, expected.b.uu);
  EXPECT_EQ(rtl.b.vv, expected.b.vv);
  EXPECT_EQ(rtl.b.uv, expected.b.uv);
  EXPECT_EQ(rtl.p, expected.p);
  EXPECT_EQ(rtl.t, expected.t);
  EXPECT_EQ(rtl.acc, expected.acc);
  EXPECT_EQ(rtl.lum.lum, expected.lum.lum);
  EXPECT_EQ(rtl.lum.saturated, expected.lum.saturated);
}

TEST_P(RtlValues, EveryStageRegisterHoldsTheReferencesIntermediateValue) {
  const auto rtl = GetParam().make();
  for (std::uint64_t n = 0; n < 2000; ++n) {
    SCOPED_TRACE(n);
    const auto in = lrgb_vector(GetParam().config, 4, n);
    const RtlTrace trace = rtl->trace(in);
    const auto expected = reference::evaluate_lrgb(GetParam().config, in);
    expect_same_trace(trace.luminance, expected.luminance);
    EXPECT_EQ(trace.product, expected.product);
    EXPECT_EQ(trace.color.out, expected.color.out);
    EXPECT_EQ(trace.color.saturated, expected.color.saturated);

    const auto rgb = rgb_vector(GetParam().config, 4, n);
    const auto passes = rtl->trace(rgb);
    const auto expected_rgb = reference::evaluate_rgb(GetParam().config, rgb);
    for (unsigned c = 0; c < 3; ++c) {
      expect_same_trace(passes[c].luminance, expected_rgb.channel[c]);
      EXPECT_EQ(passes[c].color.out[c], expected_rgb.color.out[c]);
    }
    if (HasFailure()) return;
  }
}

TEST_P(RtlValues, NamesOfATraceComeInOrderOfTheDatapath) {
  const auto rtl = GetParam().make();
  const auto named = named_values(rtl->trace(lrgb_vector(GetParam().config, 5, 0)));
  ASSERT_EQ(named.size(), 31U);
  EXPECT_EQ(named[0].first, "d0");
  EXPECT_EQ(named[6].first, "uu");
  EXPECT_EQ(named[9].first, "p0");
  EXPECT_EQ(named[21].first, "acc");
  EXPECT_EQ(named[24].first, "product_r");
  EXPECT_EQ(named[30].first, "color_saturated");
}

INSTANTIATE_TEST_SUITE_P(Variants, RtlValues, testing::ValuesIn(rtl_variants()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::testbench
