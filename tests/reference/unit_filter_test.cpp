// Steps U7 to U9 and U11 against real arithmetic, and how many multiplies they take.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/reference/counting_integer.h"
// The counting type must be complete before the steps' templates look its functions up.
#include "model/reference/unit/combine.h"
#include "model/reference/unit/coordinate.h"
#include "model/reference/unit/filter.h"

namespace ptm::reference {
namespace {

using tests::Counting;
using tests::OperationLog;

/// Errors of one narrow: (-1/2, 1/2] rounding to nearest, ties upward; (-1, 0] truncating.
struct RoundingError {
  Rounding rounding;
  double low, high;
};
constexpr std::array<RoundingError, 2> kRoundings{
    {{Rounding::nearest, -0.5, 0.5}, {Rounding::truncate, -1, 0}}};

Value edge_or_any(std::mt19937_64& rng, Value most) {
  const auto pick = rng() % 4;
  return pick == 0   ? 0
         : pick == 1 ? most
                     : static_cast<Value>(rng() % static_cast<std::uint64_t>(most + 1));
}

double real_bilinear(const Taps<Value>& t, Value wu, Value wv) {
  const double u = static_cast<double>(wu) / 256, v = static_cast<double>(wv) / 256;
  const auto at = [&](unsigned k) { return static_cast<double>(t[k]); };
  return (at(0) * (1 - u) + at(1) * u) * (1 - v) + (at(2) * (1 - u) + at(3) * u) * v;
}

TEST(Bilinear, IsWithinTwoRoundingsOfTheRealOneAndBetweenItsTaps) {
  std::mt19937_64 rng(1);
  for (const auto& [rounding, low, high] : kRoundings) {
    for (int n = 0; n < 200000; ++n) {
      const Value most = (Value{1} << (8 + n % 7)) - 1;  // 8 to 14 bits
      Taps<Value> taps{};
      for (Value& tap : taps) tap = edge_or_any(rng, most);
      const Value wu = edge_or_any(rng, 255), wv = edge_or_any(rng, 255);
      const Value got = bilinear(rounding, taps, wu, wv);
      const double error = static_cast<double>(got) - real_bilinear(taps, wu, wv);
      // top and bottom are off by one rounding each, so their mean is; a second one on top
      ASSERT_GE(error, 2 * low);
      ASSERT_LE(error, 2 * high);
      ASSERT_GE(got, *std::min_element(taps.begin(), taps.end()));
      ASSERT_LE(got, *std::max_element(taps.begin(), taps.end()));
    }
  }
}

TEST(Bilinear, TakesNothingFromATapOfWeightZero) {
  for (const auto& [rounding, low, high] : kRoundings) {
    EXPECT_EQ(bilinear(rounding, Taps<Value>{77, 1023, 1023, 1023}, Value{0}, Value{0}), 77);
    EXPECT_EQ(bilinear(rounding, Taps<Value>{77, 99, 1023, 1023}, Value{13}, Value{0}),
              lerp(rounding, Value{77}, Value{99}, Value{13}));
    EXPECT_EQ(bilinear(rounding, Taps<Value>{77, 1023, 99, 1023}, Value{0}, Value{13}),
              lerp(rounding, Value{77}, Value{99}, Value{13}));
  }
}

TEST(FilterChain, OfLevelsAndProbesIsWithinFourRoundingsOfTheRealOne) {
  std::mt19937_64 rng(2);
  for (const auto& [rounding, low, high] : kRoundings) {
    for (int n = 0; n < 20000; ++n) {
      const int log2 = n % 5;
      const Value f = edge_or_any(rng, 255);
      Value sum = 0;
      double real = 0;
      for (int probe = 0; probe < 1 << log2; ++probe) {
        std::array<Value, 2> level{};
        std::array<double, 2> exact{};
        for (unsigned m = 0; m < 2; ++m) {
          Taps<Value> taps{};
          for (Value& tap : taps) tap = edge_or_any(rng, 4095);
          const Value wu = edge_or_any(rng, 255), wv = edge_or_any(rng, 255);
          level[m] = bilinear(rounding, taps, wu, wv);
          exact[m] = real_bilinear(taps, wu, wv);
        }
        sum += lerp(rounding, level[0], level[1], f);
        real += exact[0] + (exact[1] - exact[0]) * static_cast<double>(f) / 256;
      }
      const auto mean = static_cast<double>(probe_mean(rounding, sum, Value{log2}));
      const double error = mean - real / (1 << log2);
      // bilinear two, the level one, the mean one
      ASSERT_GE(error, 4 * low);
      ASSERT_LE(error, 4 * high);
    }
  }
}

/// The combine in real numbers, limited to a byte.
double real_combine(Combine combine, const CombineOperands<>& in) {
  const auto p = static_cast<double>(in.lit), c = static_cast<double>(in.color);
  const double alpha = static_cast<double>(in.color_alpha) / 255;
  switch (combine) {
    case Combine::modulate:
      return p * c / 255;
    case Combine::decal:
      return c * alpha + p * (1 - alpha);
    case Combine::blend:
      return std::min(255.0,
                      (static_cast<double>(in.kd) * p + static_cast<double>(in.ka) * c) / 256);
    case Combine::add:
      return std::min(255.0, p + c);
    case Combine::replace:
      return c;
    default:
      return p;
  }
}

TEST(CombineChannel, IsWithinARoundingOfRealArithmeticForEveryPairAndManyWeights) {
  for (const auto& [rounding, low, high] : kRoundings) {
    for (int code = 0; code < 6; ++code) {
      const auto combine = static_cast<Combine>(code);
      for (Value p = 0; p < 256; ++p) {
        for (Value c = 0; c < 256; ++c) {
          for (const Value weight : {Value{0}, (p * 7 + c) % 256, Value{255}}) {
            const CombineOperands<> in{p, c, weight, 2 * weight, (511 - weight) % 512};
            const Value got = combine_channel(rounding, combine, in);
            const double error = static_cast<double>(got) - real_combine(combine, in);
            ASSERT_GE(error, low - 1e-9) << code << ' ' << p << ' ' << c << ' ' << weight;
            ASSERT_LE(error, high + 1e-9) << code << ' ' << p << ' ' << c << ' ' << weight;
            ASSERT_TRUE(got >= 0 && got <= 255);
          }
        }
      }
    }
  }
}

int lerp_multiplies(int fields, bool two_levels) {
  OperationLog& log = OperationLog::instance();
  log.clear();
  const Counting w{7};
  for (int k = 0; k < fields; ++k) {
    const Taps<Counting> taps{Counting{1}, Counting{2}, Counting{3}, Counting{4}};
    const Counting first = bilinear(Rounding::nearest, taps, w, w);
    if (!two_levels) continue;
    (void)lerp(Rounding::nearest, first, bilinear(Rounding::nearest, taps, w, w), w);
  }
  EXPECT_EQ(log.of(Step::narrow).multiplies, 0);
  return log.of(Step::lerp).multiplies;
}

TEST(UnitOperationCount, OfABilinearLrgbTexelIsTwentySevenLerps) {
  EXPECT_EQ(lerp_multiplies(9, false), 27) << "six coefficients and three colours";
  EXPECT_EQ(lerp_multiplies(10, false), 30) << "and alpha";
  EXPECT_EQ(lerp_multiplies(9, true), 63) << "two footprints, and one lerp between them";
}

TEST(UnitOperationCount, OfAnAddressIsOneMultiplyADirectionAndOfItsWrapNone) {
  OperationLog& log = OperationLog::instance();
  log.clear();
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp}) {
    (void)wrap_coordinate(wrap, Counting{-12345});
  }
  EXPECT_EQ(log.of(Step::wrap).multiplies, 0);
  (void)texel_position(true, Counting{12345}, Counting{402});
  EXPECT_EQ(log.of(Step::scale).multiplies, 1);
  (void)texel_position(false, Counting{12345}, Counting{402});
  EXPECT_EQ(log.of(Step::scale).multiplies, 2);
  (void)probe_mean(Rounding::nearest, Counting{12345}, Counting{4});
  EXPECT_EQ(log.of(Step::probes).multiplies + log.of(Step::narrow).multiplies, 0);
}

TEST(UnitOperationCount, OfAChannelsCombineIsOneForModulateAndTwoForDecalAndBlend) {
  OperationLog& log = OperationLog::instance();
  const std::array<int, 6> expected{0, 1, 2, 2, 0, 0};
  for (std::size_t code = 0; code < expected.size(); ++code) {
    log.clear();
    const CombineOperands<Counting> in{Counting{1}, Counting{2}, Counting{3}, Counting{4},
                                       Counting{5}};
    (void)combine_channel(Rounding::nearest, static_cast<Combine>(code), in);
    EXPECT_EQ(log.of(Step::combine).multiplies, expected[code]) << code;
    EXPECT_EQ(log.of(Step::narrow).multiplies, 0);
  }
}

}  // namespace
}  // namespace ptm::reference
