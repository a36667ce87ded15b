// The models of the whole unit that know time, each in a process of its own.
#include <stdexcept>

#include "model/pipeline/estimate_texture_unit.h"
#include "model/pipeline/simulate_texture_unit.h"
#include "testbench/run/prepare_rtl.h"
#include "testbench/run/stopwatch.h"
#include "testbench/run/unit_models.h"
#include "testbench/run/unit_rtl.h"

namespace ptm::testbench {
namespace {

using pipeline::UnitFrame;
using pipeline::UnitFrameResult;
using reference::UnitCounter;

constexpr int kScanSpan = 16;  ///< of a scan line, for timing loose

/// A frame to draw, and whether it counts or only warms the caches.
struct PlannedFrame {
  UnitFrame frame;
  bool counted = true;
};

std::vector<PlannedFrame> plan(const UnitJob& job) {
  std::vector<PlannedFrame> frames;
  for (const UnitFrameInput& input : job.frames) {
    const bool keep = job.scene.keep_cache && !frames.empty();
    frames.push_back({{input.fragments, keep}, !job.scene.draw_twice});
    if (job.scene.draw_twice) frames.push_back({{input.fragments, true}, true});
  }
  return frames;
}

void put(ResultFile& file, const UnitFrameResult& frame) {
  file.put(frame.taken);
  file.put(frame.answered);
  file.put(frame.pixels);
  file.put(frame.counters);
  file.put(frame.fault ? frame.fault->what : std::string());
  file.put(frame.fault ? frame.fault->cycle : pipeline::Cycle{0});
}

UnitFrameResult get(ResultFile& file) {
  UnitFrameResult frame;
  frame.taken = file.get_vector<pipeline::Cycle>();
  frame.answered = file.get_vector<pipeline::Cycle>();
  frame.pixels = file.get_vector<reference::UnitPixel>();
  frame.counters = file.get<reference::UnitCounters>();
  const auto what = file.get_vector<char>();
  const auto cycle = file.get<pipeline::Cycle>();
  if (!what.empty()) frame.fault = {std::string(what.begin(), what.end()), cycle};
  return frame;
}

/// Timing loose, frame by frame. It keeps no state: where a frame finds the caches as the ones
/// before left them, its time is that of all of them less that of the ones before.
void estimate(const UnitJob& job, const pipeline::UnitSimulation& simulation) {
  const int tile = job.scene.traversal == golden::Traversal::tiles ? job.scene.tile : kScanSpan;
  const auto run = [&](std::span<const reference::UnitFragment> fragments) {
    return pipeline::estimate_texture_unit(simulation.unit, *simulation.state, {fragments},
                                           simulation.memory, tile, simulation.timing,
                                           simulation.eval);
  };
  std::vector<reference::UnitFragment> before;
  pipeline::UnitEstimate spent;
  for (std::size_t n = 0; n < simulation.frames.count; ++n) {
    const UnitFrame frame = simulation.frames.make(n);
    if (!frame.keep_cache) {
      before.clear();
      spent = {};
    }
    pipeline::UnitEstimate all;
    if (before.empty()) {
      all = run(frame.fragments);
      if (simulation.frames.count > 1)
        before.assign(frame.fragments.begin(), frame.fragments.end());
    } else {
      before.insert(before.end(), frame.fragments.begin(), frame.fragments.end());
      all = run(before);
    }
    UnitFrameResult result;
    result.counters[UnitCounter::fragments] = frame.fragments.size();
    result.counters[UnitCounter::pixels] = frame.fragments.size();
    result.counters[UnitCounter::cycles] = all.cycles - spent.cycles;
    result.counters[UnitCounter::beats] = all.beats - spent.beats;
    result.counters[UnitCounter::lines_read] = all.lines_read - spent.lines_read;
    spent = all;
    simulation.frames.take(n, std::move(result));
  }
}

void run_model(const UnitJob& job, const std::string& model,
               const pipeline::UnitSimulation& simulation) {
  if (model == "pipeline") return pipeline::simulate_texture_unit(simulation);
  if (model == "loose") return estimate(job, simulation);
  if (model == "rtl") return simulate_unit_rtl(job, simulation);
  throw std::invalid_argument("no timed model '" + model + "'");
}

/// Runs a model over the job's frames; those that count go into the file, each behind a true, then
/// a false and the time. A fault ends the run: then frames are missing.
void simulate(const UnitJob& job, const std::string& model, ResultFile& file) {
  const std::vector<PlannedFrame> frames = plan(job);
  pipeline::UnitSimulation simulation = unit_simulation(job);
  double writing = 0, loading = 0;
  const Stopwatch watch;
  simulation.frames.count = frames.size();
  simulation.frames.make = [&](std::size_t n) {
    if (n == 0) loading = watch.seconds();  // registers written, modules elaborated
    return frames[n].frame;
  };
  simulation.frames.take = [&](std::size_t n, UnitFrameResult&& result) {
    const Stopwatch taking;
    if (frames[n].counted || result.fault) {
      file.put(true);
      put(file, result);
    }
    writing += taking.seconds();
  };
  run_model(job, model, simulation);
  const double seconds = watch.seconds() - loading - writing;
  file.put(false);
  file.put(seconds);
}

}  // namespace

pipeline::UnitSimulation unit_simulation(const UnitJob& job) {
  pipeline::UnitSimulation simulation;
  simulation.unit = job.unit;
  simulation.eval = job.config;
  simulation.state = &job.state;
  simulation.timing = job.timing;
  simulation.memory = job.memory;
  return simulation;
}

ChildProcess start_unit_model(const UnitJob& job, const std::string& model) {
  if (model == "rtl") prepare_rtl_unit(job.config, job.unit);
  return {"the " + model + " model",
          [&job, model](ResultFile& file) { simulate(job, model, file); }};
}

UnitTimed take_unit_model(ChildProcess& child, const std::string& model) {
  ResultFile& file = child.wait();
  UnitTimed timed;
  timed.model = model;
  while (file.get<bool>()) timed.frames.push_back(get(file));
  timed.seconds = file.get<double>();
  return timed;
}

}  // namespace ptm::testbench
