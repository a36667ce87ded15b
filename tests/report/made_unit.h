#pragma once
#include <cmath>
#include <numbers>

#include "tests/report/made_run.h"

/// Runs of the whole texture unit that no model made: counts that fit together as real ones do.
namespace ptm::tests {

/// 65,536 pixels of two draws, three textures: 3,100 lines, 117,422 cycles, or in loose 119,300.
inline reference::UnitCounters made_counters(bool loose) {
  using enum reference::UnitCounter;
  reference::UnitCounters n;
  n[fragments] = n[pixels] = 65536;
  n[cycles] = loose ? 119300 : 117422;
  n[cycles_moved] = n[beats] = 90000;
  n[cycles_output_blocked] = 2100;
  n[cycles_line_wait] = loose ? 26188 : 24310;
  n[cycles_ring_full] = 900;
  n[cycles_input_empty] = 112;
  n[bank_conflicts] = 320;
  n[words] = 229376;
  n[taps] = 917504;
  n[tag_hits] = 320000;
  n[tag_misses] = n[lines_read] = 3100;
  n[duplicate_lines] = 240;
  n[multiplies_address] = 131072;
  n[multiplies_filter] = 2752512;
  n[multiplies_eval] = 720896;
  n[multiplies_combine] = 98304;
  n.hits(0, 0) = 150000;
  n.misses(0, 0) = 1500;
  n.hits(0, 1) = 50000;
  n.misses(0, 1) = 700;
  n.hits(1, 0) = 120000;
  n.misses(1, 0) = 900;
  return n;
}

/// `lines` over `windows` windows, with three waves: none is lost to rounding.
inline std::vector<std::uint32_t> made_windows(std::size_t windows, std::uint32_t lines) {
  std::vector<std::uint32_t> made;
  std::uint32_t before = 0;
  for (std::size_t i = 1; i <= windows; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(windows);
    const double waves = 6 * std::numbers::pi;
    const auto until =
        static_cast<std::uint32_t>(std::lround(lines * (t + 0.9 / waves * std::sin(waves * t))));
    made.push_back(until - before);
    before = until;
  }
  return made;
}

inline testbench::UnitSection made_unit() {
  testbench::UnitSection unit;
  unit.memory = "fixed latency of 100 cycles, a line every 4";
  unit.window = 64;
  unit.draws = {{"floor", "tiles.ptm", "grass.png", 2}, {"ball", "ball.ptm", "", 1}};
  const std::vector<std::uint32_t> windows = made_windows(1835, 3100);
  unit.timings = {{"pipeline", 0.0089, false, made_counters(false), windows},
                  {"loose", 0.00071, false, made_counters(true), {}},
                  {"rtl", 0.1526, false, made_counters(false), windows}};
  return unit;
}

inline testbench::RunResult made_unit_run(int width, int height, std::size_t frames) {
  testbench::RunResult run = made_run(width, height, frames);
  run.scene_file = "scenes/floor_and_ball.toml";
  run.unit = made_unit();
  run.config.unit = {run.unit->config, pipeline::FixedMemory{}, {}, {}};
  for (testbench::FrameLight& light : run.lights) {
    light = {0.6, -0.48, 0.64, testbench::FrameLight::Kind::direction};
  }
  return run;
}

/// The same of a unit that is built without the counter `duplicate_lines`, or without any; loose is
/// an estimate.
inline testbench::RunResult made_unit_without_counters(int width, int height,
                                                       bool only_duplicates) {
  testbench::RunResult run = made_unit_run(width, height, 1);
  run.unit->config.counters = only_duplicates;
  run.unit->config.duplicate_lines = false;
  run.config.unit->unit = run.unit->config;
  run.unit->timings[1].estimate = true;
  for (testbench::UnitTiming& timing : run.unit->timings) {
    if (!timing.estimate) timing.counters.keep_built(run.unit->config);
  }
  return run;
}

/// A pipeline that is a cycle late at two pixels, on a palettised map of one draw; loose is an
/// estimate, as it is when a scene is run.
inline testbench::RunResult made_late_run(int width, int height) {
  testbench::RunResult run = made_unit_run(width, height, 1);
  testbench::UnitSection& unit = *run.unit;
  for (testbench::UnitTiming& timing : unit.timings) {
    timing.counters[reference::UnitCounter::palette_lookups] = 262144;
  }
  unit.timings[1].estimate = true;
  unit.timings[1].lines_per_window.clear();
  reference::UnitCounters& n = unit.timings[0].counters;
  n[reference::UnitCounter::cycles] += 40;
  n[reference::UnitCounter::cycles_line_wait] += 40;
  unit.timings[0].lines_per_window = made_windows(1836, 3100);
  unit.late_pixels = 2;
  run.lights.front().kind = testbench::FrameLight::Kind::position;
  unit.differing_counters = {"cycles", "cycles_line_wait"};
  return run;
}

}  // namespace ptm::tests
