// Shading fragments one after the other: what a frame's values cost in the reference.
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "model/reference/unit/shade.h"

namespace ptm::reference {
namespace {

constexpr int kSide = 256;

StoredTexture noise_map(bool rgb) {
  std::mt19937 rng(1);
  StoredTexture map{kSide, kSide, rgb, {}, {}, {}, {}};
  map.coef.resize(static_cast<std::size_t>(kSide * kSide) * (rgb ? 18 : 6));
  for (auto& c : map.coef) c = static_cast<std::uint16_t>(rng() & 255U);
  if (!rgb) map.color.resize(static_cast<std::size_t>(kSide * kSide) * 3);
  for (auto& c : map.color) c = static_cast<std::uint8_t>(rng());
  return map;
}

UnitState scene(bool rgb, bool linear) {
  UnitState state;
  std::vector<StoredTexture> levels{noise_map(rgb)};
  Draw draw;
  draw.format = rgb ? TextureFormat::rgb : TextureFormat::lrgb;
  if (linear) {
    levels.push_back(levels[0]);
    levels[1].width = levels[1].height = kSide / 2;
    levels[1].coef.resize(levels[1].coef.size() / 4);
    levels[1].color.resize(levels[1].color.size() / 4);
    draw.mip = Mip::linear;
  }
  draw.map = append_map(kBase, levels, state.memory);
  draw.bias.fill(128);
  state.draws.push_back(draw);
  return state;
}

/// Half a texel a step, row by row, as a magnified plane has them.
std::vector<UnitFragment> fragments(bool linear) {
  std::vector<UnitFragment> out;
  constexpr int kStep = (1 << 20) / kSide / 2;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      UnitFragment f;
      f.x = static_cast<std::uint16_t>(x);
      f.y = static_cast<std::uint16_t>(y);
      f.u = x * kStep + 321;
      f.v = y * kStep + 123;
      f.lod = linear ? 100 : 0;
      f.lu = x;
      f.lv = y;
      out.push_back(f);
    }
  }
  return out;
}

void shading(benchmark::State& bench, const EvalConfig& config, bool rgb, bool linear) {
  const UnitState state = scene(rgb, linear);
  const std::vector<UnitFragment> in = fragments(linear);
  std::vector<UnitPixel> out(in.size());
  for (auto _ : bench) {
    shade_all(config, state, in, out);
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  bench.SetItemsProcessed(bench.iterations() * static_cast<std::int64_t>(in.size()));
}

constexpr EvalConfig kOther{.guard = 5};  ///< known at run time only

BENCHMARK_CAPTURE(shading, lrgb_bilinear_base, kBase, false, false);
BENCHMARK_CAPTURE(shading, lrgb_bilinear_other, kOther, false, false);
BENCHMARK_CAPTURE(shading, lrgb_trilinear_base, kBase, false, true);
BENCHMARK_CAPTURE(shading, rgb_bilinear_base, kBase, true, false);

}  // namespace
}  // namespace ptm::reference

BENCHMARK_MAIN();
