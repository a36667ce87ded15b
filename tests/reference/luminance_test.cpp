// D1 to D6 against a second derivation in wide integers and division, and against the widths.
#include "model/reference/luminance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/reference/exact_rational.h"
#include "tests/reference/random_config.h"

namespace ptm::reference {
namespace {

using tests::limit;
using tests::round_scaled;
using tests::Wide;

struct Expected {
  Wide lum = 0;
  bool saturated = false;
};

/// docs/spec/datapath.md, "Steps", read once more with division instead of shifts.
Expected by_division(const EvalConfig& c, const LrgbOperands<>& in) {
  const bool nearest = c.rounding == Rounding::nearest;
  const Wide delta_top = Wide{1} << (c.delta_bits + c.filter_frac - 1);
  const Wide basis_top = Wide{1} << (2 * c.light_int - 2 + c.basis_frac);
  const auto square = [&](Wide a, Wide b) {
    return limit(round_scaled(a * b, 2 * c.light_frac - c.basis_frac, nearest), -basis_top,
                 basis_top - 1);
  };
  const std::array<Wide, 6> factor{
      square(in.lu, in.lu), square(in.lv, in.lv), square(in.lu, in.lv), in.lu, in.lv, 1};
  const std::array<int, 6> frac{c.basis_frac, c.basis_frac, c.basis_frac,
                                c.light_frac, c.light_frac, 0};
  Wide acc = 0;
  for (unsigned i = 0; i < 6; ++i) {
    const Wide d = limit(Wide{in.coef[i]} - Wide{in.bias[i]} * (Wide{1} << c.filter_frac),
                         -delta_top, delta_top - 1);
    acc += round_scaled(d * factor[i],
                        frac[i] + c.filter_frac + static_cast<int>(in.shift[i]) - c.guard, nearest);
  }
  const Wide exact = round_scaled(acc, c.guard - c.lum_frac, nearest);
  const Wide lum = limit(exact, 0, (Wide{1} << (c.lum_bits + c.lum_frac)) - 1);
  return {lum, lum != exact};
}

void expect_fits(Value value, int bits, const char* what) {
  const Value top = Value{1} << (bits - 1);
  ASSERT_TRUE(value >= -top && value < top) << what << " = " << value << " in " << bits << " bits";
}

/// Every intermediate value lies in the width that the RTL holds it in.
void expect_widths(const EvalConfig& c, const LuminanceTrace<Value>& trace) {
  const EvalWidths w = widths(c);
  for (unsigned i = 0; i < 6; ++i) {
    expect_fits(trace.d[i], w.delta, "d");
    expect_fits(trace.p[i], w.product[i], "p");
    expect_fits(trace.t[i], w.term, "t");
  }
  expect_fits(trace.b.uu, w.basis, "uu");
  expect_fits(trace.b.vv, w.basis, "vv");
  expect_fits(trace.b.uv, w.basis, "uv");
  expect_fits(trace.acc, w.sum, "acc");
}

TEST(Luminance, EqualsTheContractReadWithDivisionOnRandomConfigurations) {
  std::mt19937_64 rng(20261122);
  for (int n = 0; n < 4000; ++n) {
    const EvalConfig config = tests::random_config(rng);
    validate(config);
    for (int k = 0; k < 50; ++k) {
      const auto in = tests::random_operands(rng, config);
      const auto trace = evaluate_luminance(config, in.coef, in.bias, in.shift, in.lu, in.lv);
      const Expected expected = by_division(config, in);
      ASSERT_EQ(static_cast<Wide>(trace.lum.lum) - expected.lum, 0) << "configuration " << n;
      ASSERT_EQ(trace.lum.saturated, expected.saturated ? 1 : 0);
      expect_widths(config, trace);
    }
  }
}

/// The sum's width is needed: its extreme is reached within a factor of two.
TEST(Luminance, SumsWidthIsNotWasteful) {
  for (const Preset& preset : kPresets) {
    const EvalConfig& c = preset.config;
    LrgbOperands<> in;
    in.coef.fill((1 << c.coef_bits) - 1);
    in.shift.fill(c.shift_min);
    in.lu = in.lv = -(Value{1} << (c.light_int + c.light_frac - 1));
    in.coef[3] = in.coef[4] = 0;
    in.bias[3] = in.bias[4] = (1 << c.coef_bits) - 1;
    const auto trace = evaluate_luminance(c, in.coef, in.bias, in.shift, in.lu, in.lv);
    EXPECT_GE(trace.acc, Value{1} << (widths(c).sum - 3)) << preset.name;
  }
}

TEST(Luminance, OfBaseStaysWithinItsDerivedBoundOfTheRealPolynomial) {
  // Nothing saturates at scale 1 and |l| <= 1. Error: the light code half a unit of 2^-8 on every
  // first-order term and twice that on the squares, the basis half a unit of 2^-8, each term half
  // a unit of 2^-4, and the result half a unit.
  std::mt19937_64 rng(7);
  std::uniform_real_distribution<double> light(-1, 1);
  for (int n = 0; n < 20000; ++n) {
    Six<Value> coef, bias{}, shift{};
    for (auto& x : coef) x = static_cast<Value>(rng() % 64);
    coef[5] += 100;
    const double u = light(rng), v = light(rng);
    const auto lu = static_cast<Value>(std::floor(u * 256 + 0.5));
    const auto lv = static_cast<Value>(std::floor(v * 256 + 0.5));
    std::array<double, 6> a{};
    for (unsigned i = 0; i < 6; ++i) a[i] = static_cast<double>(coef[i]);
    const double real = a[0] * u * u + a[1] * v * v + a[2] * u * v + a[3] * u + a[4] * v + a[5];
    if (real < 0) continue;
    const auto lum = evaluate_luminance(kBase, coef, bias, shift, lu, lv).lum.lum;
    const double per_code = 0x1p-9;
    const double squares = (a[0] + a[1] + a[2]) * (2 * per_code + per_code * per_code + 0x1p-9);
    const double bound = squares + (a[3] + a[4]) * per_code + 6 * 0x1p-5 + 0.5;
    EXPECT_LE(std::abs(static_cast<double>(lum) - real), bound);
  }
}

}  // namespace
}  // namespace ptm::reference
