// The models of the whole unit that know time, each in a process of its own.
#include <array>

#include "model/pipeline/simulate_texture_unit.h"
#include "testbench/rtl/verilated_unit.h"
#include "testbench/run/stopwatch.h"
#include "testbench/run/unit_models.h"

namespace ptm::testbench {
namespace {

using pipeline::UnitFrame;
using pipeline::UnitFrameResult;

struct PlannedFrame {
  UnitFrame frame;
  bool counted = true;
};

/// Every light's frame; drawn twice, the first warms the caches.
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
  file.put(frame.fault.has_value());
  if (!frame.fault) return;
  file.put(frame.fault->what);
  file.put(frame.fault->cycle);
}

UnitFrameResult get(ResultFile& file) {
  UnitFrameResult frame;
  frame.taken = file.get_vector<pipeline::Cycle>();
  frame.answered = file.get_vector<pipeline::Cycle>();
  frame.pixels = file.get_vector<reference::UnitPixel>();
  frame.counters = file.get<reference::UnitCounters>();
  if (!file.get<bool>()) return frame;
  const auto what = file.get_vector<char>();
  frame.fault = {std::string(what.begin(), what.end()), file.get<pipeline::Cycle>()};
  return frame;
}

void put_all(ResultFile& file, const std::vector<UnitFrameResult>& frames, double seconds) {
  file.put(frames.size());
  for (const UnitFrameResult& frame : frames) put(file, frame);
  file.put(seconds);
}

}  // namespace
}  // namespace ptm::testbench
