#include "testbench/run/timed_models.h"

#include <algorithm>
#include <array>

#include "model/pipeline/simulate.h"
#include "testbench/run/stopwatch.h"

namespace ptm::testbench {
namespace {

using pipeline::Cycle;
using pipeline::FrameResult;
using reference::Fragment;

constexpr std::array<const char*, 8> kCounters{
    "fragments",     "pixels",          "cycles",        "evaluator_cycles",
    "words_fetched", "multiplies_eval", "input_stalled", "output_blocked"};
using CounterValues = std::array<std::uint64_t, kCounters.size()>;

CounterValues counters_of(const FrameResult& frame, std::uint64_t fragments) {
  return {fragments,           frame.pixels.size(), frame.total_cycles,  frame.evaluator_cycles,
          frame.words_fetched, frame.multiplies,    frame.input_stalled, frame.output_blocked};
}

/// One frame into the file: pixels' colours, cycles, counters.
void put_frame(ResultFile& file, const FrameResult& frame, std::uint64_t fragments) {
  std::vector<std::array<std::uint8_t, 3>> colors(frame.pixels.size());
  std::transform(frame.pixels.begin(), frame.pixels.end(), colors.begin(),
                 [](const pipeline::Pixel& pixel) { return pixel.out; });
  std::vector<Cycle> cycles(frame.cycles.size());
  std::transform(frame.cycles.begin(), frame.cycles.end(), cycles.begin(),
                 [&](Cycle cycle) { return cycle - frame.first_operand; });
  file.put(colors);
  file.put(cycles);
  file.put(counters_of(frame, fragments));
}

golden::ImageReal image_of(const std::vector<std::array<std::uint8_t, 3>>& colors, int width,
                           int height) {
  golden::ImageReal image(width, height, 3);
  auto sample = image.samples.begin();
  for (const auto& color : colors) sample = std::copy(color.begin(), color.end(), sample);
  return image;
}

void simulate_pipeline(const FlatJob& job, ResultFile& file) {
  std::vector<Fragment> fragments;
  double drawing = 0;  // fragments are software's, the same for every model
  const pipeline::FrameStream frames{job.lights.size(),
                                     [&](std::size_t frame) {
                                       const Stopwatch watch;
                                       fragments =
                                           make_fragments(job, job.config, job.lights[frame]);
                                       drawing += watch.seconds();
                                       return std::span<const Fragment>(fragments);
                                     },
                                     [&](std::size_t, FrameResult&& result) {
                                       const Stopwatch watch;
                                       put_frame(file, result, fragments.size());
                                       drawing += watch.seconds();
                                     }};
  const Stopwatch watch;
  pipeline::simulate_unit(job.config, {job.tmus}, job.hardware.texture, frames);
  file.put(watch.seconds() - drawing);
}

}  // namespace

ChildProcess start_pipeline(const FlatJob& job) {
  return {"the pipeline model", [&](ResultFile& file) { simulate_pipeline(job, file); }};
}

TimedResult take_result(ChildProcess& child, const std::string& model, const FlatJob& job) {
  ResultFile& file = child.wait();
  TimedResult timed;
  timed.model.model = model;
  CounterValues totals{};
  for (std::size_t frame = 0; frame < job.lights.size(); ++frame) {
    const auto colors = file.get_vector<std::array<std::uint8_t, 3>>();
    timed.model.frames.push_back(image_of(colors, job.width, job.height));
    timed.cycles.push_back(file.get_vector<Cycle>());
    const auto values = file.get<CounterValues>();
    std::transform(totals.begin(), totals.end(), values.begin(), totals.begin(), std::plus<>());
  }
  timed.model.seconds = file.get<double>();
  for (std::size_t i = 0; i < kCounters.size(); ++i) {
    timed.model.counters.push_back({kCounters[i], totals[i]});
  }
  timed.model.cycles = totals[2];
  return timed;
}

}  // namespace ptm::testbench
