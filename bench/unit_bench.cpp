// Fragments and cycles a second of the pipeline model's timings, values apart, and of the Verilated
// unit: 1024 x 1024 LRGB, bilinear, on a plane, 16 x 16 tiles, cold, default memory
// (docs/spec/unit-timing.md, "Two timings"). SystemC elaborates once a process.
#include <cstdio>
#include <ctime>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

#include "model/pipeline/estimate_texture_unit.h"
#include "model/pipeline/memory_timing.h"
#include "model/pipeline/simulate_texture_unit.h"
#include "testbench/rtl/unit_variants.h"

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

/// Lines of the map's three planes, all zero: what they hold costs nobody anything.
constexpr std::size_t kMapLines = std::size_t{3} * (kSide / 4) * (kSide / 4);

/// One frame's processor time and what it simulated.
struct Frame {
  double seconds = std::numeric_limits<double>::infinity();
  std::uint64_t fragments = 0, cycles = 0, lines = 0;
};

/// Prints the frame and keeps the faster one.
void report(const char* timing, const Frame& frame, Frame& best) {
  std::printf("%s: %.3g fragments/s, %.3g cycles/s, %.4f s a frame, %llu cycles, %llu lines\n",
              timing, static_cast<double>(frame.fragments) / frame.seconds,
              static_cast<double>(frame.cycles) / frame.seconds, frame.seconds,
              static_cast<unsigned long long>(frame.cycles),
              static_cast<unsigned long long>(frame.lines));
  if (frame.seconds < best.seconds) best = frame;
}

Frame frame_of(double seconds, const ptm::reference::UnitCounters& c) {
  return {seconds, c[UnitCounter::fragments], c[UnitCounter::cycles], c[UnitCounter::lines_read]};
}

Frame time_loose(const UnitState& state, const std::vector<UnitFragment>& fragments) {
  constexpr int kFrames = 10;
  const double begin = cpu_seconds();
  ptm::pipeline::UnitEstimate estimate;
  for (int frame = 0; frame < kFrames; ++frame) {
    estimate = ptm::pipeline::estimate_texture_unit({}, state, {fragments},
                                                    ptm::pipeline::FixedMemory{}, kTile);
  }
  return {(cpu_seconds() - begin) / kFrames, estimate.fragments, estimate.cycles,
          estimate.lines_read};
}

/// The Verilated unit, one thread; its harness is in what is timed, the load of the state is not.
class Rtl {
 public:
  explicit Rtl(UnitState state) {
    state.memory.resize(kMapLines);
    unit_->load(state);
  }
  Frame time(const std::vector<UnitFragment>& fragments) {
    const double begin = cpu_seconds();
    const UnitFrameResult result = unit_->run({fragments}, *memory_, {});
    return frame_of(cpu_seconds() - begin, result.counters);
  }

 private:
  std::unique_ptr<ptm::testbench::RtlUnit> unit_ =
      ptm::testbench::make_rtl_unit(ptm::reference::kBase, {});
  std::unique_ptr<ptm::pipeline::MemoryTiming> memory_ =
      ptm::pipeline::make_memory(ptm::pipeline::FixedMemory{});
};

struct Best {
  Frame loose, exact, rtl;
};

/// Each in turn, round after round, so that a machine whose speed swings is fair to all three.
/// SystemC elaborates once a process: the rounds are the frames of one simulation.
Best bench(const UnitState& state, const std::vector<UnitFragment>& fragments) {
  constexpr std::size_t kRounds = 6;
  Best best;
  Rtl rtl(state);
  UnitSimulation simulation;
  simulation.state = &state;
  double begin = 0;
  simulation.frames.count = kRounds;
  simulation.frames.make = [&](std::size_t) {
    begin = cpu_seconds();
    return ptm::pipeline::UnitFrame{fragments};
  };
  simulation.frames.take = [&](std::size_t, UnitFrameResult&& result) {
    report("exact", frame_of(cpu_seconds() - begin, result.counters), best.exact);
    report("loose", time_loose(state, fragments), best.loose);
    report("RTL", rtl.time(fragments), best.rtl);
  };
  ptm::pipeline::simulate_texture_unit(simulation);
  return best;
}

}  // namespace

/// `unit_bench rtl` runs one frame of the RTL alone, for a profiler.
int main(int argc, char** argv) {
  const UnitState state = plane_state();
  const auto fragments = plane_fragments();
  if (argc > 1 && std::string_view(argv[1]) == "rtl") {
    Frame best;
    report("RTL", Rtl(state).time(fragments), best);
    return 0;
  }
  const auto [loose, exact, rtl] = bench(state, fragments);
  std::printf(
      "best, processor time a frame: RTL %.3g cycles/s; RTL : exact %.1f, RTL : loose %.0f\n",
      static_cast<double>(rtl.cycles) / rtl.seconds, rtl.seconds / exact.seconds,
      rtl.seconds / loose.seconds);
}
