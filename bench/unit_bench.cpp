// Fragments a second of the pipeline model's timings, values apart: 1024 x 1024 LRGB, bilinear, on
// a plane, 16 x 16 tiles, cold, default memory (docs/spec/pipeline.md, "Two timings"). One process
// runs one timing, because SystemC elaborates once.
#include <cstdio>
#include <ctime>
#include <vector>

#include "model/pipeline/estimate_texture_unit.h"
#include "model/pipeline/simulate_texture_unit.h"

namespace {

using ptm::pipeline::UnitFrameResult;
using ptm::pipeline::UnitSimulation;
using ptm::reference::UnitCounter;
using ptm::reference::UnitFragment;
using ptm::reference::UnitState;

constexpr int kSide = 1024, kTile = 16;

/// Processor time, so that other work on the machine does not count.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

UnitState plane_state() {
  UnitState state;
  ptm::reference::Draw draw;
  draw.map = {.width = kSide, .height = kSide};
  state.draws.push_back(draw);
  return state;
}

/// A plane seen almost straight on, a texel a pixel, off the texels' centres by a third.
std::vector<UnitFragment> plane_fragments() {
  std::vector<UnitFragment> fragments;
  fragments.reserve(std::size_t{kSide} * kSide);
  for (int ty = 0; ty < kSide; ty += kTile) {
    for (int tx = 0; tx < kSide; tx += kTile) {
      for (int y = ty; y < ty + kTile; ++y) {
        for (int x = tx; x < tx + kTile; ++x) {
          UnitFragment fragment;
          fragment.x = static_cast<std::uint16_t>(x);
          fragment.y = static_cast<std::uint16_t>(y);
          fragment.u = x * (1 << 20) / kSide + 800;
          fragment.v = y * (1 << 20) / kSide + 800;
          fragments.push_back(fragment);
        }
      }
    }
  }
  return fragments;
}

void report(const char* timing, double seconds, std::uint64_t fragments, std::uint64_t cycles,
            std::uint64_t lines) {
  std::printf("%s: %.3g fragments/s, %.4f s a frame, %llu cycles, %llu lines\n", timing,
              static_cast<double>(fragments) / seconds, seconds,
              static_cast<unsigned long long>(cycles), static_cast<unsigned long long>(lines));
}

void bench_loose(const UnitState& state, const std::vector<UnitFragment>& fragments) {
  for (int round = 0; round < 4; ++round) {
    constexpr int kFrames = 10;
    const double begin = cpu_seconds();
    ptm::pipeline::UnitEstimate estimate;
    for (int frame = 0; frame < kFrames; ++frame) {
      estimate = ptm::pipeline::estimate_texture_unit({}, state, {fragments},
                                                      ptm::pipeline::FixedMemory{}, kTile);
    }
    report("loose", (cpu_seconds() - begin) / kFrames, estimate.fragments, estimate.cycles,
           estimate.lines_read);
  }
}

void bench_exact(const UnitState& state, const std::vector<UnitFragment>& fragments) {
  constexpr std::size_t kFrames = 6;
  UnitSimulation simulation;
  simulation.state = &state;
  double begin = 0;
  simulation.frames.count = kFrames;
  simulation.frames.make = [&](std::size_t) {
    begin = cpu_seconds();
    return ptm::pipeline::UnitFrame{fragments};
  };
  simulation.frames.take = [&](std::size_t, UnitFrameResult&& result) {
    const auto& c = result.counters;
    report("exact", cpu_seconds() - begin, c[UnitCounter::fragments], c[UnitCounter::cycles],
           c[UnitCounter::lines_read]);
  };
  ptm::pipeline::simulate_texture_unit(simulation);
}

}  // namespace

int main() {
  const UnitState state = plane_state();
  const auto fragments = plane_fragments();
  bench_loose(state, fragments);
  bench_exact(state, fragments);
}
