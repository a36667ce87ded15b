#pragma once
#include <gtest/gtest.h>

#include <vector>

#include "model/pipeline/simulate.h"
#include "testbench/rtl/verilated_evaluator.h"
#include "testbench/vectors/vector_generator.h"

/// The same vectors through reference, RTL and pipeline, a stream at a time.
namespace ptm::tests {

struct Differences {
  std::uint64_t rtl_values = 0, pipeline_values = 0, cycles = 0;
};

inline bool same(const pipeline::Pixel& a, const testbench::RtlPixel& b) {
  return a.lum == b.lum && a.out == b.out && a.lum_saturated == b.lum_saturated &&
         a.color_saturated == b.color_saturated;
}

/// Streams `count` pixels through the RTL, then through the pipeline model. `operands(n)` makes a
/// pixel's operands, `expected(n)` is the reference's pixel. Elaborates SystemC.
template <class Operands, class Expected>
Differences compare_three(const reference::Preset& preset, std::uint64_t count,
                          const pipeline::StreamTiming& timing,
                          const std::function<Operands(std::uint64_t)>& operands,
                          const Expected& expected) {
  Differences found;
  std::vector<std::uint64_t> taken(count);
  Operands at_hand;
  const std::function<const Operands&(std::uint64_t)> source =
      [&](std::uint64_t n) -> const Operands& { return at_hand = operands(n); };
  const testbench::RtlEvaluator::Sink from_rtl =
      [&](std::uint64_t n, const testbench::RtlPixel& pixel, std::uint64_t cycle) {
        found.rtl_values += pixel == expected(n) ? 0U : 1U;
        taken[n] = cycle;
      };
  const auto rtl = testbench::make_rtl_evaluator(preset.config);
  testbench::RtlCounters counters;
  if constexpr (std::is_same_v<Operands, reference::LrgbOperands<>>) {
    counters = rtl->stream_lrgb(count, timing, source, from_rtl);
  } else {
    counters = rtl->stream_rgb(count, timing, source, from_rtl);
  }
  const auto frame = pipeline::stream_evaluator(
      preset.config, count, source,
      [&](std::uint64_t n, const pipeline::Pixel& pixel, pipeline::Cycle cycle) {
        found.pipeline_values += same(pixel, expected(n)) ? 0U : 1U;
        found.cycles += cycle == taken[n] ? 0U : 1U;
      },
      timing);
  EXPECT_EQ(frame.evaluator_cycles, counters.cycles);
  EXPECT_EQ(frame.input_stalled, counters.input_stalled);
  EXPECT_EQ(frame.output_blocked, counters.output_blocked);
  return found;
}

inline Differences compare_lrgb(const reference::Preset& preset, std::uint64_t count,
                                std::uint64_t seed, const pipeline::StreamTiming& timing) {
  const auto vector = [&](std::uint64_t n) {
    return testbench::lrgb_vector(preset.config, seed, n);
  };
  return compare_three<reference::LrgbOperands<>>(
      preset, count, timing, vector, [&](std::uint64_t n) {
        return testbench::to_pixel(reference::evaluate_lrgb(preset.config, vector(n)));
      });
}

inline Differences compare_rgb(const reference::Preset& preset, std::uint64_t count,
                               std::uint64_t seed, const pipeline::StreamTiming& timing) {
  const auto vector = [&](std::uint64_t n) {
    return testbench::rgb_vector(preset.config, seed, n);
  };
  return compare_three<reference::RgbOperands<>>(
      preset, count, timing, vector, [&](std::uint64_t n) {
        return testbench::to_pixel(reference::evaluate_rgb(preset.config, vector(n)));
      });
}

inline void expect_none(const Differences& found) {
  EXPECT_EQ(found.rtl_values, 0U) << "pixels in which RTL and reference differ";
  EXPECT_EQ(found.pipeline_values, 0U) << "pixels in which pipeline and reference differ";
  EXPECT_EQ(found.cycles, 0U) << "pixels that leave RTL and pipeline in different cycles";
}

}  // namespace ptm::tests
