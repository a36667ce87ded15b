// The bound on one evaluation's error: proved by Gappa where bits are dropped, sampled as a whole.
#include "model/reference/error_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>
#include <sstream>

#include "model/reference/light_code.h"
#include "testbench/rtl/command.h"
#include "tests/reference/random_config.h"
#include "tests/scratch_folder.h"

namespace ptm::reference {
namespace {

using Shifts = std::array<int, 6>;

/// The largest magnitude of each coefficient that D1 can give.
std::array<double, 6> largest(const EvalConfig& config, const Shifts& shift) {
  const int bits = std::min(config.delta_bits - 1, config.coef_bits);
  std::array<double, 6> a{};
  for (std::size_t i = 0; i < 6; ++i) a[i] = std::ldexp(1.0, bits - shift[i]);
  return a;
}

/// One loss and the most that it may be.
struct Goal {
  std::string loss;
  double most;
};

/// The losses of which error_bound() adds up basis, terms and luminance:
///
///     lum - real = (lum - acc) + sum_i (t_i - x_i) + sum_i (x_i - e_i)
///
/// with x_i the product before D4 drops bits, e_i that of the unrounded basis. Each is what
/// error_bound() says of a polynomial that has this coefficient alone.
std::vector<Goal> goals_of(const EvalConfig& config, const Shifts& shift) {
  const std::array<double, 6> a = largest(config, shift);
  std::vector<Goal> goals{{"lum - acc", error_bound(config, a, shift).luminance}};
  for (std::size_t i = 0; i < 6; ++i) {
    std::array<double, 6> alone{};
    alone[i] = a[i];
    const ErrorBound bound = error_bound(config, alone, shift);
    const std::string n = std::to_string(i);
    goals.push_back({"t" + n + " - x" + n, bound.terms});
    if (i < 3) goals.push_back({"x" + n + " - e" + n, bound.basis});
  }
  return goals;
}

std::string power(int exponent) { return "1b" + std::to_string(exponent); }

/// D2 to D6 without a limit, and the polynomial itself, in Gappa's words.
std::string gappa_script(const EvalConfig& c, const Shifts& shift, double share) {
  const char* way = c.rounding == Rounding::nearest ? "nu" : "dn";
  std::ostringstream s;
  s.precision(17);
  s << "@basis = fixed<-" << c.basis_frac << "," << way << ">;\n@term = fixed<-" << c.guard << ","
    << way << ">;\n@level = fixed<-" << c.lum_frac << "," << way << ">;\n"
    << "uu = basis(lu * lu);\nvv = basis(lv * lv);\nuv = basis(lu * lv);\n";
  const char* rounded[] = {"uu", "vv", "uv", "lu", "lv"};
  const char* exact[] = {"(lu * lu)", "(lv * lv)", "(lu * lv)", "lu", "lv"};
  const auto product = [&](int i, const char* const* basis) {
    std::string text = "d" + std::to_string(i) + " * " + power(-shift[static_cast<std::size_t>(i)]);
    if (i < 5) text.append(" * ").append(basis[i]);
    return text;
  };
  for (int i = 0; i < 6; ++i) {
    s << "x" << i << " = " << product(i, rounded) << ";\ne" << i << " = " << product(i, exact)
      << ";\nt" << i << " = term(x" << i << ");\n";
  }
  s << "acc = t0 + t1 + t2 + t3 + t4 + t5;\nlum = level(acc);\n"
    << "{ @FIX(lu, -" << c.light_frac << ") /\\ @FIX(lv, -" << c.light_frac << ")";
  const int last = (1 << (c.light_int - 1 + c.light_frac)) - 1;
  for (const char* light : {"lu", "lv"}) {
    s << " /\\ " << light << " in [-" << last << "b-" << c.light_frac << ", " << last << "b-"
      << c.light_frac << "]";
  }
  const int most = 1 << std::min(c.delta_bits - 1, c.coef_bits);
  for (int i = 0; i < 6; ++i) {
    s << " /\\ d" << i << " in [-" << most << ", " << most << "] /\\ @FIX(d" << i << ", -"
      << c.filter_frac << ")";
  }
  const char* between = "\n  -> |";
  for (const Goal& goal : goals_of(c, shift)) {
    s << between << goal.loss << "| <= " << std::hexfloat << share * goal.most;
    between = "\n  /\\ |";
  }
  s << " }\n";
  return s.str();
}

/// Whether Gappa proves that every loss is within this share of its bound.
bool gappa_proves(const EvalConfig& config, const Shifts& shift, double share) {
  const tests::ScratchFolder folder;
  const auto script = folder.write("bound.gappa", gappa_script(config, shift, share));
  return testbench::run_command({"gappa", script.string()}, folder / "log") == 0;
}

/// The sum of the losses, which must be what error_bound() says of the whole polynomial.
double total(const EvalConfig& config, const Shifts& shift) {
  double sum = 0;
  for (const Goal& goal : goals_of(config, shift)) sum += goal.most;
  const ErrorBound bound = error_bound(config, largest(config, shift), shift);
  EXPECT_NEAR(sum, bound.basis + bound.terms + bound.luminance, 1e-9 * sum);
  return sum;
}

std::vector<Shifts> some_shifts(const EvalConfig& c) {
  const int low = c.shift_min;
  return {{0, 0, 0, 0, 0, 0},
          {low, low, low, low, low, low},
          {15, 15, 15, 15, 15, 15},
          {low, 0, 3, 1, 15, low},
          {2, low, 7, low, 4, 5}};
}

class ErrorBoundOf : public testing::TestWithParam<Preset> {};

TEST_P(ErrorBoundOf, DroppedBitsIsProvedByGappa) {
  const EvalConfig& config = GetParam().config;
  for (const Shifts& shift : some_shifts(config)) {
    EXPECT_TRUE(gappa_proves(config, shift, 1));
    std::cout << GetParam().name << ", shifts from " << shift[0] << " on: " << total(config, shift)
              << " levels\n";
  }
}

TEST(ErrorBound, DroppedBitsIsNotProvedOfMuchLess) {
  EXPECT_FALSE(gappa_proves(kPaper8, Shifts{}, 0.9));
}

/// Six coefficients as codes, drawn within D1's range.
struct Draw {
  LrgbOperands<> operands;
  std::array<double, 6> a{};
  Shifts shift{};
};

Draw draw_polynomial(std::mt19937_64& random, const EvalConfig& config, int most_shift) {
  Draw draw;
  const int bits = std::min(config.delta_bits - 1, config.coef_bits);
  for (std::size_t i = 0; i < 6; ++i) {
    const int shift = std::uniform_int_distribution(config.shift_min, most_shift)(random);
    const Value bias = (Value{1} << bits) / 2;
    const Value coef = std::uniform_int_distribution<Value>(0, (Value{1} << bits) - 1)(random);
    draw.operands.coef[i] = coef << config.filter_frac;
    draw.operands.bias[i] = bias;
    draw.operands.shift[i] = draw.shift[i] = shift;
    draw.a[i] = std::ldexp(static_cast<double>(coef - bias), -shift);
  }
  for (auto& channel : draw.operands.rgb) {
    channel = std::uniform_int_distribution<Value>(0, 255)(random) << config.filter_frac;
  }
  return draw;
}

double polynomial(const std::array<double, 6>& a, double u, double v) {
  return a[0] * u * u + a[1] * v * v + a[2] * u * v + a[3] * u + a[4] * v + a[5];
}

TEST_P(ErrorBoundOf, AnEvaluationHoldsUnderEveryLightOfTheDiscAndIsComeNearTo) {
  const EvalConfig& config = GetParam().config;
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> unit(0, 1);
  double nearest_luminance = 0, nearest_channel = 0;
  const double top = static_cast<double>((1 << (config.lum_bits + config.lum_frac)) - 1) /
                     std::ldexp(1.0, config.lum_frac);
  for (int n = 0; n < 300000; ++n) {
    Draw draw = draw_polynomial(random, config, 3);
    // Half of the lights on the rim, where codes end.
    const double r = n % 2 == 0 ? 1 : std::sqrt(unit(random));
    const double at = n % 16 == 0 ? 0 : 2 * std::numbers::pi * unit(random);
    const double u = r * std::cos(at), v = r * std::sin(at);
    draw.operands.lu = light_code(config, u).value();
    draw.operands.lv = light_code(config, v).value();
    const ErrorBound bound = error_bound(config, draw.a, draw.shift);
    const auto trace = evaluate_lrgb(config, draw.operands);
    const double real = std::clamp(polynomial(draw.a, u, v), 0.0, top);
    const double lum = std::ldexp(static_cast<double>(trace.luminance.lum.lum), -config.lum_frac);
    ASSERT_LE(std::abs(lum - real), bound.of_luminance() + 1e-9);
    nearest_luminance = std::max(nearest_luminance, std::abs(lum - real) / bound.of_luminance());
    for (std::size_t c = 0; c < 3; ++c) {
      const double color =
          std::ldexp(static_cast<double>(draw.operands.rgb[c]), -config.filter_frac);
      const double lit = std::min(color * real / 255, 255.0);
      const double error = std::abs(static_cast<double>(trace.color.out[c]) - lit);
      ASSERT_LE(error, bound.of_lrgb_channel(color) + 1e-9);
      nearest_channel = std::max(nearest_channel, error / bound.of_lrgb_channel(color));
    }
  }
  std::cout << GetParam().name << ": luminance comes to " << nearest_luminance
            << " of its bound, a channel to " << nearest_channel << '\n';
  EXPECT_GT(nearest_luminance, 0.6);
  EXPECT_GT(nearest_channel, 0.6);
}

INSTANTIATE_TEST_SUITE_P(Presets, ErrorBoundOf, testing::ValuesIn(kPresets),
                         [](const auto& preset) { return std::string(preset.param.name); });

TEST(ErrorBound, DroppedBitsIsProvedByGappaForRandomConfigurations) {
  std::mt19937_64 random(23);
  for (int n = 0; n < 40; ++n) {
    const EvalConfig config = tests::random_config(random);
    Shifts shift{};
    for (int& s : shift) s = std::uniform_int_distribution(config.shift_min, 15)(random);
    EXPECT_TRUE(gappa_proves(config, shift, 1)) << n;
    (void)total(config, shift);
  }
}

TEST(ErrorBound, IsNothingWhereNoBitIsDropped) {
  EvalConfig config = kBase;
  config.basis_frac = 2 * config.light_frac;
  config.guard = config.lum_frac = 4;
  const ErrorBound bound = error_bound(config, {0, 0, 0, 0, 0, 255}, {0, 0, 0, 0, 0, 4});
  EXPECT_EQ(bound.of_luminance(), 0);
  EXPECT_EQ(bound.color, 0.5 + 0.5 / 255);
}

}  // namespace
}  // namespace ptm::reference
