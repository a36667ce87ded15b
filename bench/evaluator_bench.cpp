// The Verilated evaluator compared against the reference in every cycle, and each alone.
//
// One LRGB pixel a cycle, no gaps, no stalls. `compared` is what the issue asks for: more than
// 8 million cycles a second on one core. The counter `cycles` is clock cycles of the RTL, or
// pixels of the reference, a second of CPU time.
#include <benchmark/benchmark.h>

#include <vector>

#include "model/reference/constant_config.h"
#include "testbench/rtl/verilated_evaluator.h"
#include "testbench/vectors/vector_generator.h"

namespace ptm::testbench {
namespace {

constexpr std::uint64_t kPool = 4096;  // operands, used over and over: fits the second-level cache
constexpr std::uint64_t kPixels = 1 << 17;

std::vector<reference::LrgbOperands<>> make_pool(const reference::EvalConfig& config) {
  std::vector<reference::LrgbOperands<>> pool;
  for (std::uint64_t i = 0; i < kPool; ++i) pool.push_back(lrgb_vector(config, 1, i));
  return pool;
}

void count_cycles(benchmark::State& state, std::uint64_t cycles) {
  state.counters["cycles"] =
      benchmark::Counter(static_cast<double>(cycles), benchmark::Counter::kIsRate);
}

void rtl_alone(benchmark::State& state, const reference::Preset& preset) {
  const auto pool = make_pool(preset.config);
  const auto rtl = make_rtl_evaluator(preset.name);
  std::uint64_t cycles = 0, sum = 0;
  for (auto _ : state) {
    cycles +=
        rtl->stream_lrgb(
               kPixels, {}, [&](std::uint64_t n) -> const auto& { return pool[n % kPool]; },
               [&](std::uint64_t, const RtlPixel& pixel, std::uint64_t) { sum += pixel.out[0]; })
            .cycles;
  }
  benchmark::DoNotOptimize(sum);
  count_cycles(state, cycles);
}

void reference_alone(benchmark::State& state, const reference::Preset& preset) {
  const auto pool = make_pool(preset.config);
  std::uint64_t pixels = 0;
  for (auto _ : state) {
    reference::with_constant_config(preset.config, [&](const auto& config) {
      for (std::uint64_t n = 0; n < kPixels; ++n) {
        RtlPixel pixel = to_pixel(reference::evaluate_lrgb(config, pool[n % kPool]));
        benchmark::DoNotOptimize(pixel);
      }
    });
    pixels += kPixels;
  }
  count_cycles(state, pixels);
}

void compared(benchmark::State& state, const reference::Preset& preset) {
  const auto pool = make_pool(preset.config);
  const auto rtl = make_rtl_evaluator(preset.name);
  std::uint64_t cycles = 0, differing = 0;
  for (auto _ : state) {
    reference::with_constant_config(preset.config, [&](const auto& config) {
      cycles += rtl->stream_lrgb(
                       kPixels, {}, [&](std::uint64_t n) -> const auto& { return pool[n % kPool]; },
                       [&](std::uint64_t n, const RtlPixel& pixel, std::uint64_t) {
                         const auto& in = pool[n % kPool];
                         differing += pixel != to_pixel(reference::evaluate_lrgb(config, in));
                       })
                    .cycles;
    });
  }
  if (differing != 0) state.SkipWithError("RTL and reference differ");
  count_cycles(state, cycles);
}

const bool registered = [] {
  for (const reference::Preset& preset : reference::kPresets) {
    const std::string name(preset.name);
    benchmark::RegisterBenchmark((name + "/compared").c_str(), compared, preset);
    benchmark::RegisterBenchmark((name + "/rtl_alone").c_str(), rtl_alone, preset);
    benchmark::RegisterBenchmark((name + "/reference_alone").c_str(), reference_alone, preset);
  }
  return true;
}();

}  // namespace
}  // namespace ptm::testbench

BENCHMARK_MAIN();
