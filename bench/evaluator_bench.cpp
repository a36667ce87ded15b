// The Verilated evaluator compared against the reference in every cycle, and each alone.
//
// One LRGB pixel a cycle, no gaps, no stalls. `compared` is what the issue asks for: more than
// 8 million cycles a second on one core; rate_reporter.h says which figure that is. The counter
// `cycles` is clock cycles of the RTL, or pixels of the reference, a second of CPU time.
#include <benchmark/benchmark.h>

#include <array>
#include <vector>

#include "bench/rate_reporter.h"
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
  const auto rtl = make_rtl_evaluator(preset.config);
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

/// Pixels of the RTL, compared with the reference's a batch at a time: each by itself would wait
/// for the evaluation before it, and the processor overlaps nothing.
template <class Config>
class Comparison {
 public:
  Comparison(const Config& config, const std::vector<reference::LrgbOperands<>>& pool)
      : config_(config), pool_(pool) {}

  void take(std::uint64_t n, const RtlPixel& pixel) {
    batch_[n % kBatch] = pixel;
    if (n % kBatch == kBatch - 1) compare(n + 1 - kBatch);
  }
  [[nodiscard]] std::uint64_t compared() const { return compared_; }
  [[nodiscard]] std::uint64_t differing() const { return differing_; }

 private:
  static constexpr std::uint64_t kBatch = 64;
  static_assert(kPixels % kBatch == 0, "the last batch is full");

  void compare(std::uint64_t first) {
    for (std::uint64_t i = 0; i < kBatch; ++i) {
      const auto& in = pool_[(first + i) % kPool];
      differing_ += batch_[i] != to_pixel(reference::evaluate_lrgb(config_, in));
    }
    compared_ += kBatch;
  }

  const Config& config_;
  const std::vector<reference::LrgbOperands<>>& pool_;
  std::array<RtlPixel, kBatch> batch_;
  std::uint64_t compared_ = 0, differing_ = 0;
};

void compared(benchmark::State& state, const reference::Preset& preset) {
  const auto pool = make_pool(preset.config);
  const auto rtl = make_rtl_evaluator(preset.config);
  std::uint64_t cycles = 0, pixels = 0, compared = 0, differing = 0;
  reference::with_constant_config(preset.config, [&](const auto& config) {
    Comparison comparison(config, pool);
    for (auto _ : state) {
      const RtlCounters counters = rtl->stream_lrgb(
          kPixels, {}, [&](std::uint64_t n) -> const auto& { return pool[n % kPool]; },
          [&](std::uint64_t n, const RtlPixel& pixel, std::uint64_t) {
            comparison.take(n, pixel);
          });
      cycles += counters.cycles;
      pixels += counters.pixels;
    }
    compared = comparison.compared();
    differing = comparison.differing();
  });
  if (differing != 0) state.SkipWithError("RTL and reference differ");
  if (compared != pixels) state.SkipWithError("not every pixel was compared");
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

int main(int argc, char** argv) {
  ptm::bench::RateReporter reporter("cycles", "reference_alone");
  return ptm::bench::run_all(argc, argv, reporter);
}
