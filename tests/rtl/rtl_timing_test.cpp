// When the RTL gives its pixels: latency, occupancy, throughput, stability under stall, assembly.
// The rules are docs/spec/handshake.md (H1..H5) and docs/spec/evaluator.md.
#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "tests/rtl/rtl_checks.h"

namespace ptm::testbench {
namespace {

constexpr unsigned kLatency = 8;
constexpr unsigned kCapacity = 9;

class RtlTiming : public testing::TestWithParam<RtlVariant> {
 protected:
  void SetUp() override { rtl_->reset(); }

  [[nodiscard]] RtlPins beat(std::uint64_t n) const {
    RtlPins pins;
    pins.valid = true;
    pins.operands = lrgb_vector(GetParam().config, 1, n);
    pins.sideband = static_cast<std::uint32_t>(n);
    return pins;
  }
  [[nodiscard]] RtlPins pass(std::uint64_t n, unsigned channel) const {
    const auto in = rgb_vector(GetParam().config, 1, n);
    RtlPins pins;
    pins.valid = true;
    pins.rgb_map = true;
    pins.channel = channel;
    pins.operands = {in.coef[channel], in.bias, in.shift, {}, in.lu, in.lv};
    pins.sideband = static_cast<std::uint32_t>(n);
    return pins;
  }
  [[nodiscard]] RtlPixel lrgb(std::uint64_t n) const {
    return to_pixel(
        reference::evaluate_lrgb(GetParam().config, lrgb_vector(GetParam().config, 1, n)));
  }
  [[nodiscard]] RtlPixel rgb(std::uint64_t n) const {
    return to_pixel(
        reference::evaluate_rgb(GetParam().config, rgb_vector(GetParam().config, 1, n)));
  }
  static RtlPins idle(bool ready = true) {
    RtlPins pins;
    pins.ready = ready;
    return pins;
  }
  /// Offers beats first, first + 1, ... with the output blocked; how many are accepted in 40
  /// cycles.
  unsigned fill(std::uint64_t first = 0) {
    unsigned accepted = 0;
    for (unsigned cycle = 0; cycle < 40; ++cycle) {
      RtlPins pins = beat(first + accepted);
      pins.ready = false;
      accepted += rtl_->cycle(pins).ready;
    }
    return accepted;
  }

  std::unique_ptr<RtlEvaluator> rtl_ = GetParam().make();
};

TEST_P(RtlTiming, NothingIsOfferedAfterReset) {
  for (unsigned cycle = 0; cycle < 20; ++cycle) {
    const RtlSeen seen = rtl_->cycle(idle());
    EXPECT_FALSE(seen.valid) << cycle;
    EXPECT_TRUE(seen.ready) << cycle;
  }
}

TEST_P(RtlTiming, ResultIsAbsentInCycle7AndPresentInCycle8) {
  ASSERT_TRUE(rtl_->cycle(beat(0)).ready);
  for (unsigned cycle = 1; cycle < kLatency; ++cycle) {
    EXPECT_FALSE(rtl_->cycle(idle()).valid) << "cycle " << cycle;
  }
  const RtlSeen seen = rtl_->cycle(idle());
  EXPECT_TRUE(seen.valid);
  EXPECT_EQ(seen.pixel, lrgb(0));
  EXPECT_FALSE(rtl_->cycle(idle()).valid) << "the pixel was taken";
}

TEST_P(RtlTiming, OnePixelLeavesInEveryCycleWhenNothingStalls) {
  for (std::uint64_t cycle = 0; cycle < 200; ++cycle) {
    const RtlSeen seen = rtl_->cycle(beat(cycle));
    EXPECT_TRUE(seen.ready) << cycle;
    ASSERT_EQ(seen.valid, cycle >= kLatency) << cycle;
    if (seen.valid) {
      EXPECT_EQ(seen.pixel, lrgb(cycle - kLatency)) << cycle;
    }
  }
}

TEST_P(RtlTiming, ExactlyNineBeatsAreAcceptedWhileTheOutputIsBlocked) {
  EXPECT_EQ(fill(), kCapacity);
}

TEST_P(RtlTiming, ABlockedUnitRunsAtFullRateOnReleaseWithoutLossOrDuplication) {
  ASSERT_EQ(fill(), kCapacity);
  std::uint64_t next_in = kCapacity, next_out = 0;
  unsigned refused = 0;
  for (unsigned cycle = 0; cycle < 60; ++cycle) {
    const RtlSeen seen = rtl_->cycle(beat(next_in));
    ASSERT_TRUE(seen.valid) << "a bubble in cycle " << cycle;
    EXPECT_EQ(seen.sideband, next_out);
    EXPECT_EQ(seen.pixel, lrgb(next_out)) << next_out;
    ++next_out;
    refused += !seen.ready;
    next_in += seen.ready;
  }
  // The FIFO's ready is registered: a full unit accepts again one cycle after its first pixel left.
  EXPECT_EQ(refused, 1U);
}

TEST_P(RtlTiming, ReadyInDoesNotReachReadyOutInTheSameCycle) {
  ASSERT_EQ(fill(), kCapacity);
  RtlPins pins = beat(kCapacity);
  pins.ready = true;
  EXPECT_FALSE(rtl_->cycle(pins).ready) << "full at the start of the cycle";
  EXPECT_TRUE(rtl_->cycle(pins).ready);
}

TEST_P(RtlTiming, BubblesCloseUpWhileTheOutputIsBlocked) {
  unsigned accepted = 0;
  for (unsigned cycle = 0; cycle < 60; ++cycle) {
    RtlPins pins = cycle % 3 == 0 ? beat(accepted) : idle();
    pins.ready = false;
    const RtlSeen seen = rtl_->cycle(pins);
    accepted += pins.valid && seen.ready;
  }
  EXPECT_EQ(accepted, kCapacity);
}

TEST_P(RtlTiming, AnOfferedPixelStaysUntouchedUntilItIsTaken) {
  std::uint64_t next_in = 0, next_out = 0;
  std::optional<RtlSeen> held;
  for (std::uint64_t cycle = 0; cycle < 3000; ++cycle) {
    RtlPins pins = beat(next_in);
    pins.valid = pipeline::hash(1, cycle) % 4 != 0;
    pins.ready = pipeline::hash(2, cycle) % 3 == 0;
    const RtlSeen seen = rtl_->cycle(pins);
    if (held) {
      ASSERT_TRUE(seen.valid) << "withdrawn in cycle " << cycle;
      EXPECT_EQ(seen.pixel, held->pixel) << "changed in cycle " << cycle;
      EXPECT_EQ(seen.sideband, held->sideband) << "changed in cycle " << cycle;
    }
    held.reset();
    if (seen.valid && !pins.ready) held = seen;
    if (seen.valid && pins.ready) {
      EXPECT_EQ(seen.pixel, lrgb(next_out));
      EXPECT_EQ(seen.sideband, next_out++);
    }
    next_in += pins.valid && seen.ready;
  }
  EXPECT_GT(next_out, 500U);
}

TEST_P(RtlTiming, AnRgbPixelAppearsEightCyclesAfterItsThirdPass) {
  for (unsigned channel = 0; channel < 3; ++channel) {
    ASSERT_FALSE(rtl_->cycle(pass(0, channel)).valid);
  }
  for (unsigned cycle = 1; cycle < kLatency; ++cycle) {
    ASSERT_FALSE(rtl_->cycle(idle()).valid) << cycle;
  }
  const RtlSeen seen = rtl_->cycle(idle());
  EXPECT_TRUE(seen.valid);
  EXPECT_EQ(seen.pixel, rgb(0));
}

TEST_P(RtlTiming, ABlockedUnitHoldsFifteenPassesOfAnRgbMap) {
  // Two pixels in the FIFO are six beats, the third pixel's first two passes wait in the assembly
  // register, its last pass in R7, and six passes behind it: 6 + 2 + 7.
  unsigned accepted = 0;
  for (unsigned cycle = 0; cycle < 60; ++cycle) {
    RtlPins pins = pass(accepted / 3, accepted % 3);
    pins.ready = false;
    accepted += rtl_->cycle(pins).ready;
  }
  EXPECT_EQ(accepted, 15U);
  std::uint64_t pixels = 0;
  for (unsigned cycle = 0; cycle < 40; ++cycle) {
    const RtlSeen seen = rtl_->cycle(idle());
    if (seen.valid) {
      EXPECT_EQ(seen.pixel, rgb(pixels)) << pixels;
    }
    pixels += seen.valid;
  }
  EXPECT_EQ(pixels, 5U);
}

TEST_P(RtlTiming, LrgbAndRgbPixelsMayFollowEachOther) {
  std::vector<RtlPins> beats;
  std::vector<RtlPixel> expected;
  for (std::uint64_t n = 0; n < 60; ++n) {
    if (pipeline::hash(3, n) % 2 == 0) {
      beats.push_back(beat(n));
      expected.push_back(lrgb(n));
    } else {
      for (unsigned channel = 0; channel < 3; ++channel) beats.push_back(pass(n, channel));
      expected.push_back(rgb(n));
    }
  }
  std::size_t in = 0, out = 0;
  for (std::uint64_t cycle = 0; cycle < 600 && out < expected.size(); ++cycle) {
    RtlPins pins = in < beats.size() ? beats[in] : idle();
    pins.ready = pipeline::hash(4, cycle) % 4 != 0;
    const RtlSeen seen = rtl_->cycle(pins);
    if (seen.valid && pins.ready) {
      EXPECT_EQ(seen.pixel, expected[out]) << out;
      EXPECT_EQ(seen.sideband, out++);
    }
    in += pins.valid && seen.ready;
  }
  EXPECT_EQ(out, expected.size());
}

TEST_P(RtlTiming, ResetEmptiesTheUnit) {
  ASSERT_EQ(fill(), kCapacity);
  rtl_->reset();
  for (unsigned cycle = 0; cycle < 20; ++cycle) EXPECT_FALSE(rtl_->cycle(idle()).valid) << cycle;
}

TEST_P(RtlTiming, CountersFollowFromTheCyclesOfAStream) {
  std::vector<reference::LrgbOperands<>> operands;
  for (std::uint64_t n = 0; n < 100; ++n) operands.push_back(lrgb_vector(GetParam().config, 1, n));
  const RtlRun run = rtl_->run(operands, {});
  EXPECT_EQ(run.counters.cycles, 100 + kLatency);
  EXPECT_EQ(run.counters.input_stalled, 0U);
  EXPECT_EQ(run.counters.output_blocked, 0U);
  EXPECT_EQ(run.taken.front(), kLatency);
  EXPECT_EQ(run.taken.back(), 99 + kLatency);
  const RtlRun blocked = rtl_->run(operands, {.seed = 1, .input_gap = 0, .output_stall = 0.5});
  EXPECT_GT(blocked.counters.output_blocked, 50U);
  EXPECT_GT(blocked.counters.input_stalled, 20U);
  EXPECT_GT(blocked.counters.cycles, 150U);
}

TEST_P(RtlTiming, AnEmptyStreamTakesNoCycles) {
  EXPECT_EQ(rtl_->run(std::span<const reference::LrgbOperands<>>(), {}).counters.cycles, 0U);
}

TEST_P(RtlTiming, ImpossibleProbabilitiesAreRefused) {
  const std::vector<reference::LrgbOperands<>> one(1);
  EXPECT_THROW(static_cast<void>(rtl_->run(one, {.seed = 1, .input_gap = 0, .output_stall = 1})),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(rtl_->run(one, {.seed = 1, .input_gap = -1, .output_stall = 0})),
               std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Variants, RtlTiming, testing::ValuesIn(rtl_variants()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::testbench
