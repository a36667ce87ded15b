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
    const Value bias = (Value{1} << bits) / 2, unit = Value{1} << config.filter_frac;
    const Value coef = std::uniform_int_distribution<Value>(0, (unit << bits) - 1)(random);
    draw.operands.coef[i] = coef;
    draw.operands.bias[i] = bias;
    draw.operands.shift[i] = draw.shift[i] = shift;
    draw.a[i] = std::ldexp(static_cast<double>(coef - bias * unit), -shift - config.filter_frac);
  }
  for (auto& channel : draw.operands.rgb) {
    channel = std::uniform_int_distribution<Value>(0, 255 << config.filter_frac)(random);
  }
  return draw;
}

double polynomial(const std::array<double, 6>& a, double u, double v) {
  return a[0] * u * u + a[1] * v * v + a[2] * u * v + a[3] * u + a[4] * v + a[5];
}

struct Shares {
  double luminance = 0, channel = 0;  ///< the worst errors, of their bounds
};

/// Random polynomials under lights of the disc, half of them on the rim, where codes end.
Shares sample(std::mt19937_64& random, const EvalConfig& config, int samples) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double top = static_cast<double>((1 << (config.lum_bits + config.lum_frac)) - 1) /
                     std::ldexp(1.0, config.lum_frac);
  Shares worst;
  for (int n = 0; n < samples; ++n) {
    Draw draw = draw_polynomial(random, config, 3);
    const double r = n % 2 == 0 ? 1 : std::sqrt(unit(random));
    const double at = n % 16 == 0 ? 0 : 2 * std::numbers::pi * unit(random);
    const double u = r * std::cos(at), v = r * std::sin(at);
    draw.operands.lu = light_code(config, u).value();
    draw.operands.lv = light_code(config, v).value();
    const ErrorBound bound = error_bound(config, draw.a, draw.shift);
    const auto trace = evaluate_lrgb(config, draw.operands);
    const double real = std::clamp(polynomial(draw.a, u, v), 0.0, top);
    const double lum = std::ldexp(static_cast<double>(trace.luminance.lum.lum), -config.lum_frac);
    worst.luminance = std::max(worst.luminance, std::abs(lum - real) / bound.of_luminance());
    const Value out = color_direct(config, Three<Value>{trace.luminance.lum.lum, 0, 0}).out[0];
    worst.channel =
        std::max(worst.channel, std::abs(static_cast<double>(out) - std::min(real, 255.0)) /
                                    (bound.of_rgb_channel() + 1e-9));
    for (std::size_t c = 0; c < 3; ++c) {
      const double color =
          std::ldexp(static_cast<double>(draw.operands.rgb[c]), -config.filter_frac);
      const double error =
          std::abs(static_cast<double>(trace.color.out[c]) - std::min(color * real / 255, 255.0));
      worst.channel = std::max(worst.channel, error / bound.of_lrgb_channel(color));
    }
  }
  return worst;
}

TEST_P(ErrorBoundOf, AnEvaluationHoldsUnderEveryLightOfTheDiscAndIsComeNearTo) {
  std::mt19937_64 random(8);
  const Shares worst = sample(random, GetParam().config, 300000);
  std::cout << GetParam().name << ": luminance comes to " << worst.luminance
            << " of its bound, a channel to " << worst.channel << '\n';
  EXPECT_LE(worst.luminance, 1);
  EXPECT_LE(worst.channel, 1);
  EXPECT_GT(worst.luminance, 0.6);
  EXPECT_GT(worst.channel, 0.6);
}

TEST(ErrorBound, OfAnEvaluationHoldsForRandomConfigurations) {
  std::mt19937_64 random(31);
  for (int n = 0; n < 400; ++n) {
    const Shares worst = sample(random, tests::random_config(random), 4000);
    EXPECT_LE(worst.luminance, 1) << n;
    EXPECT_LE(worst.channel, 1) << n;
  }
}

TEST(ErrorBound, CountsAWholeUnitWhereSquaresRoundUpToTheLimit) {
  // light_int 1, light_frac 14, basis_frac 4: 0.9961 squared rounds up to 1, which D2 cuts.
  EvalConfig config = kBase;
  config.light_int = 1;
  config.light_frac = 14;
  config.basis_frac = 4;
  EXPECT_EQ(error_bound(config, {64, 0, 0, 0, 0, 0}, {}).basis, 4);
  config.basis_frac = 16;
  EXPECT_EQ(error_bound(config, {65536, 0, 0, 0, 0, 0}, {}).basis, 0.5);
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
