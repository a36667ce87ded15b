// The stages of the effect chain, each alone: by hand, by a second reading, and within the errors
// that docs/spec/effects.md states.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/reference/counting_integer.h"
// The counting type must be complete before the stages' templates look its functions up.
#include "model/reference/effects/power_table.h"
#include "model/reference/effects/stages.h"
#include "tests/reference/exact_rational.h"
#include "tests/reference/refusal.h"

namespace ptm::reference {
namespace {

using effects::StageInput;
using effects::StagePixel;
using tests::Counting;
using tests::Wide;

EvalConfig with(Rounding rounding, int lum_frac) {
  EvalConfig config;
  config.rounding = rounding;
  config.lum_frac = lum_frac;
  return config;
}

/// What the stages are given; the pixel is black unless told otherwise.
struct Given {
  EvalConfig config = kBase;
  Draw draw;
  EffectTable table{};
  std::array<Value, kExtraPasses> value{};

  template <class Stage>
  StagePixel<> after(StagePixel<> pixel = {}) const {
    Stage::apply(StageInput<>{config, draw, table, value}, pixel);
    return pixel;
  }
};

TEST(EffectTableOfAnExponent, RisesFrom0To255LevelsAndIsTheNearestSixteenthOfThePower) {
  for (const double n : {1.0, 1.5, 2.0, 7.0, 20.0, 254.5, 255.0}) {
    const EffectTable table = effect_table(n);
    EXPECT_EQ(table[0], 0);
    EXPECT_EQ(table[255], 4080);
    for (std::size_t i = 0; i < 256; ++i) {
      EXPECT_GE(table[i], i == 0 ? 0 : table[i - 1]);
      const double power = 255 * std::exp(n * std::log(static_cast<double>(i) / 255));
      EXPECT_LE(std::abs(table[i] / 16.0 - power), 1.0 / 32 + 1e-9) << "n " << n << " i " << i;
    }
  }
  const EffectTable line = effect_table(1);
  for (std::size_t i = 0; i < 256; ++i) EXPECT_EQ(line[i], 16 * i);
  const EffectTable steepest = effect_table(255);
  EXPECT_EQ(steepest[254], 1498);  // 4080 (254 / 255)^255 = 1498.0003
}

TEST(EffectTableOfAnExponent, IsRefusedOutside1To255) {
  for (const double n : {0.0, 0.999, 255.001, -3.0, std::nan("")}) {
    EXPECT_NE(tests::refusal([&] { (void)effect_table(n); }).find(", expected 1 to 255"),
              std::string::npos);
  }
}

TEST(PowerStage, LooksUpWhatAWholeLevelSaysAndScalesItByKs) {
  Given given;
  given.table = effect_table(2);
  given.draw.ks = 256;
  for (const Value level : {0, 1, 127, 128, 254, 255, 256, 1023}) {
    given.value[0] = level;
    const auto i = static_cast<std::size_t>(std::min<Value>(level, 255));
    const Value entry = (4080 * static_cast<Value>(i * i) * 2 + 65025) / (2 * 65025);
    EXPECT_EQ(given.after<effects::power>().addend, (std::array<Value, 3>{entry, entry, entry}))
        << "level " << level;
  }
}

TEST(PowerStage, GivesNothingWithoutKsAndItsMostWithAllOfIt) {
  for (const Rounding rounding : {Rounding::nearest, Rounding::truncate}) {
    for (const int lum_frac : {0, 4}) {
      Given given;
      given.config = with(rounding, lum_frac);
      given.table.fill(4095);
      given.value[0] = (Value{1} << (10 + lum_frac)) - 1;  // saturated
      given.draw.ks = 511;
      EXPECT_EQ(given.after<effects::power>().addend[0], 8174);  // 13 bits
      given.draw.ks = 0;
      EXPECT_EQ(given.after<effects::power>().addend, (std::array<Value, 3>{}));
    }
  }
}

TEST(PowerStage, LerpsByTheFractionUpToTheLastEntryAndNotBeyondIt) {
  Given given;
  given.config = with(Rounding::nearest, 4);
  given.draw.ks = 256;
  given.table[3] = 100;
  given.table[4] = 260;
  given.table[255] = 4080;
  const auto of = [&](Value value) {
    given.value[0] = value;
    return given.after<effects::power>().addend[0];
  };
  EXPECT_EQ(of(3 * 16), 100);
  EXPECT_EQ(of(3 * 16 + 1), 110);
  EXPECT_EQ(of(3 * 16 + 15), 250);
  EXPECT_EQ(of(4 * 16), 260);
  EXPECT_EQ(of(4 * 16 + 8), 130);  // down to table[5] = 0
  EXPECT_EQ(of(254 * 16 + 8), 2040);
  EXPECT_EQ(of(255 * 16), 4080);
  EXPECT_EQ(of(255 * 16 + 15), 4080);
  EXPECT_EQ(of((1 << 14) - 1), 4080);
}

/// |d| levels of value, from a share q of 255 levels through rounding, table and lerp, against the
/// power: the page's bound, by its parts.
double bound(double n, Rounding rounding, int lum_frac) {
  const bool nearest = rounding == Rounding::nearest;
  const double d = (nearest ? 0.5 : 1.0) / (1 << lum_frac);
  double total = 255 * (1 - std::pow(1 - d / 255, n)) + 1.0 / 32;
  if (lum_frac == 0) return total;
  const bool between = n > 1 && n < 2;
  const double chord = n * (n - 1) / (8 * 255) + (between ? 1.0 / 32 : 0);
  total += std::min(chord, 255 * (1 - std::pow(1 - 1.0 / 255, n)));
  return total + (nearest ? 1.0 / 32 : 1.0 / 16);
}

TEST(PowerStage, StaysWithinTheStatedErrorOfThePowerAndComesNearIt) {
  for (const double n : {1.0, 1.2, 1.7, 2.0, 3.0, 20.0, 64.0, 255.0}) {
    for (const Rounding rounding : {Rounding::nearest, Rounding::truncate}) {
      for (const int lum_frac : {0, 1, 4}) {
        Given given;
        given.config = with(rounding, lum_frac);
        given.table = effect_table(n);
        given.draw.ks = 256;  // whole: addend is e
        const double most = bound(n, rounding, lum_frac);
        double worst = 0;
        for (int step = 0; step <= 255 * 256; ++step) {
          const double exact = step / 256.0;  // value[0] before D6 rounds it
          const double scaled = exact * (1 << lum_frac);
          given.value[0] =
              static_cast<Value>(std::floor(scaled + (rounding == Rounding::nearest ? 0.5 : 0.0)));
          const double e = static_cast<double>(given.after<effects::power>().addend[0]) / 16;
          worst = std::max(worst, std::abs(e - 255 * std::pow(exact / 255, n)));
        }
        EXPECT_LE(worst, most) << "n " << n << " lum_frac " << lum_frac;
        EXPECT_GE(worst, most / 5) << "a bound this loose says little: n " << n;
      }
    }
  }
}

TEST(ModulateStage, ScalesByOneValueOrByOneAChannel) {
  Given given;
  given.value = {999, 255, 128, 0};
  StagePixel<> pixel;
  pixel.addend = {8174, 4000, 17};
  EXPECT_EQ(given.after<effects::modulate>({{}, {4000, 4000, 4000}}).addend,
            (std::array<Value, 3>{4000, 4000, 4000}));
  given.draw.effects.argument = 1;
  EXPECT_EQ(given.after<effects::modulate>(pixel).addend,
            (std::array<Value, 3>{8174, (4000 * 129 + 128) / 256, 0}));
  given.draw.effects.argument = 0xFFFFFFFE;  // bit 0 alone is looked at
  given.value[1] = 127;
  pixel.addend.fill(512);
  EXPECT_EQ(given.after<effects::modulate>(pixel).addend, (std::array<Value, 3>{254, 254, 254}));
}

TEST(ModulateStage, LimitsAValueTo255LevelsAndRoundsItsFraction) {
  Given given;
  given.config = with(Rounding::nearest, 4);
  StagePixel<> pixel;
  pixel.addend.fill(2560);
  const auto of = [&](Value value) {
    given.value[1] = value;
    return given.after<effects::modulate>(pixel).addend[0];
  };
  EXPECT_EQ(of((1 << 14) - 1), 2560) << "saturated";
  EXPECT_EQ(of(255 * 16), 2560);
  EXPECT_EQ(of(100 * 16 + 7), 1000);
  EXPECT_EQ(of(100 * 16 + 8), 1010);
  EXPECT_EQ(of(0), 0);
  given.config.rounding = Rounding::truncate;
  EXPECT_EQ(of(100 * 16 + 15), 1000);
}

TEST(ModulateStage, IsWithinA512thOfADivisionBy255) {
  Given given;
  for (Value m = 0; m < 256; ++m) {
    given.value[1] = m;
    for (const Value addend : {0, 1, 255, 4080, 8174}) {
      StagePixel<> pixel;
      pixel.addend.fill(addend);
      const auto out = static_cast<double>(given.after<effects::modulate>(pixel).addend[0]);
      const double exact = static_cast<double>(addend * m) / 255;
      EXPECT_LE(std::abs(out - exact), static_cast<double>(addend) / 512 + 0.5) << m;
    }
  }
}

TEST(AddStage, AddsWholeLevelsAndLimitsThem) {
  Given given;
  StagePixel<> pixel{{10, 250, 255}, {7, 8 + 16 * 3, 8174}};
  EXPECT_EQ(given.after<effects::add>(pixel).rgb, (std::array<Value, 3>{10, 254, 255}));
  pixel.addend = {8, 5 * 16 + 8, 0};
  EXPECT_EQ(given.after<effects::add>(pixel).rgb, (std::array<Value, 3>{11, 255, 255}));
  given.config.rounding = Rounding::truncate;
  EXPECT_EQ(given.after<effects::add>(pixel).rgb, (std::array<Value, 3>{10, 255, 255}));
}

TEST(Stages, LeaveAloneWhatIsNotTheirs) {
  Given given;
  given.draw.ks = 300;
  given.table.fill(1234);
  given.value = {77, 88, 99, 111};
  const StagePixel<> before{{1, 2, 3}, {400, 500, 600}};
  EXPECT_EQ(given.after<effects::power>(before).rgb, before.rgb);
  EXPECT_EQ(given.after<effects::modulate>(before).rgb, before.rgb);
  EXPECT_EQ(given.after<effects::add>(before).addend, before.addend);
}

TEST(Stages, ActOnADrawThatNamesThemAloneAndInTheOrderOfTheirNumbers) {
  Given given;
  given.draw.ks = 256;
  given.table.fill(1600);          // 100 levels
  given.value = {200, 128, 0, 0};  // modulate: 129 / 256
  const auto rgb_of = [&](unsigned stages) {
    given.draw.effects.stages = stages;
    StagePixel<> pixel{{20, 20, 20}, {}};
    effects::apply_stages(StageInput<>{given.config, given.draw, given.table, given.value}, pixel);
    return pixel.rgb[0];
  };
  for (const unsigned none_added : {0U, 1U, 2U, 3U, 4U, 6U}) EXPECT_EQ(rgb_of(none_added), 20);
  EXPECT_EQ(rgb_of(5), 120);
  EXPECT_EQ(rgb_of(7), 70) << "20 + 100 * 129 / 256, the power before the modulation";
}

TEST(Stages, EqualASecondReadingOnRandomOperands) {
  std::mt19937_64 rng(1);
  const auto in = [&](Value low, Value high) {
    return std::uniform_int_distribution<Value>(low, high)(rng);
  };
  for (int n = 0; n < 100000; ++n) {
    Given given;
    const bool nearest = in(0, 1) != 0;
    const int frac = static_cast<int>(in(0, 4));
    given.config = with(nearest ? Rounding::nearest : Rounding::truncate, frac);
    given.draw.ks = in(0, 511);
    given.draw.effects.argument = static_cast<std::uint32_t>(in(0, 3));
    given.draw.effects.stages = 7;
    for (auto& entry : given.table) entry = static_cast<std::uint16_t>(in(0, 4095));
    for (Value& v : given.value) v = in(0, (Value{1} << (in(6, 12) + frac)) - 1);
    StagePixel<> pixel{{in(0, 255), in(0, 255), in(0, 255)}, {}};
    const StagePixel<> before = pixel;
    effects::apply_stages(StageInput<>{given.config, given.draw, given.table, given.value}, pixel);
    const Wide unit = Wide{1} << frac;
    const auto drop = [&](Wide x, int k) { return tests::round_scaled(x, k, nearest); };
    const Wide x = std::min<Wide>(given.value[0], 255 * unit);
    const auto entry = [&](Wide i) {
      return Wide{given.table[static_cast<std::size_t>(i < 255 ? i : 255)]};
    };
    const Wide low = entry(x / unit);
    const Wide e = low + drop((entry(x / unit + 1) - low) * (x % unit), frac);
    for (std::size_t c = 0; c < 3; ++c) {
      const Value value = given.value[given.draw.effects.argument % 2 == 1 ? c + 1 : 1];
      const Wide m = tests::limit(drop(value, frac), 0, 255);
      const Wide addend = drop(drop(given.draw.ks * e, 8) * (m >= 128 ? m + 1 : m), 8);
      ASSERT_TRUE(pixel.addend[c] == addend && addend >= 0 && addend < 8192) << "case " << n;
      ASSERT_TRUE(pixel.rgb[c] == tests::limit(before.rgb[c] + drop(addend, 4), 0, 255));
    }
  }
}

/// Multiplies of a stage, all steps within it.
template <class Stage>
int counted(const EvalConfig& config, const Draw& draw) {
  tests::OperationLog& log = tests::OperationLog::instance();
  log.clear();
  const EffectTable table{};
  StagePixel<Counting> pixel;
  Stage::apply(StageInput<Counting>{config, draw, table, {}}, pixel);
  int total = 0;
  for (const Step step : {Step::power, Step::modulate, Step::add, Step::narrow}) {
    total += log.of(step).multiplies;
  }
  return total;
}

TEST(Stages, MultiplyAsOftenAsTheySay) {
  for (const int lum_frac : {0, 4}) {
    for (const std::uint32_t argument : {0U, 1U}) {
      const EvalConfig config = with(Rounding::nearest, lum_frac);
      Draw draw;
      draw.effects.argument = argument;
      const int power = lum_frac > 0 ? 2 : 1, modulate = argument != 0 ? 3 : 1;
      EXPECT_EQ(counted<effects::power>(config, draw), power);
      EXPECT_EQ(counted<effects::modulate>(config, draw), modulate);
      EXPECT_EQ(counted<effects::add>(config, draw), 0);
      for (unsigned stages = 0; stages < 8; ++stages) {
        draw.effects.stages = stages;
        const int want = ((stages & 1) != 0 ? power : 0) + ((stages & 2) != 0 ? modulate : 0);
        EXPECT_EQ(effects::stage_multiplies(config, draw), static_cast<unsigned>(want));
      }
    }
  }
}

}  // namespace
}  // namespace ptm::reference
