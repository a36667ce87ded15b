// Quantising a 512 x 512 LRGB map, beside copying its real coefficients in memory: a ratio in one
// run, since machines are shared and noisy.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "model/quantize/quantize.h"

namespace ptm::quantize {
namespace {

constexpr int kSide = 512;

/// Coefficients as a captured relief has them: smooth, with a little noise.
std::vector<double> coefficients() {
  std::vector<double> real;
  real.reserve(kSide * kSide * kSix);
  unsigned noise = 1;
  for (int i = 0; i < kSide * kSide; ++i) {
    const double x = i % kSide / 40.0, y = i / kSide / 30.0;
    for (const double middle : {-40.0, -30.0, 0.0, 20.0, 15.0, 120.0}) {
      noise = noise * 1664525U + 1013904223U;
      real.push_back(middle + 25 * std::sin(x + middle) * std::cos(y) + (noise >> 24) / 32.0);
    }
  }
  return real;
}

void quantizing(benchmark::State& state, Method method) {
  const std::vector<double> real = coefficients();
  for (auto _ : state) {
    StoredMap map = quantize({kSide, kSide, 1, real}, reference::kBase, method, hemisphere_gram());
    benchmark::DoNotOptimize(map);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(real.size() * sizeof(double)));
}

void copying(benchmark::State& state) {
  const std::vector<double> real = coefficients();
  std::vector<double> copy(real.size());
  for (auto _ : state) {
    std::memcpy(copy.data(), real.data(), real.size() * sizeof(double));
    benchmark::DoNotOptimize(copy.data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(real.size() * sizeof(double)));
}

BENCHMARK(copying);
BENCHMARK_CAPTURE(quantizing, plain, Method::plain);
BENCHMARK_CAPTURE(quantizing, nearest_plane, Method::nearest_plane);

}  // namespace
}  // namespace ptm::quantize

BENCHMARK_MAIN();
