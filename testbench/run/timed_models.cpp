#include "testbench/run/timed_models.h"

#include <algorithm>
#include <array>

#include "model/pipeline/simulate.h"
#include "model/reference/texel_format.h"
#include "testbench/rtl/verilated_evaluator.h"
#include "testbench/run/stopwatch.h"

namespace ptm::testbench {
namespace {

using pipeline::Cycle;
using pipeline::FrameResult;
using reference::Fragment;

/// Counters by name; the RTL has no fetch yet, so what counts the whole unit is the pipeline's
/// only.
struct NamedCounter {
  const char* name;
  bool evaluators;  ///< the evaluator chain has it too
};
constexpr std::array<NamedCounter, 8> kCounters{{{"fragments", true},
                                                 {"pixels", true},
                                                 {"cycles", false},
                                                 {"evaluator_cycles", true},
                                                 {"words_fetched", false},
                                                 {"multiplies_eval", true},
                                                 {"input_stalled", true},
                                                 {"output_blocked", true}}};
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

/// Sends one frame through the verilated evaluator.
FrameResult stream_frame(RtlEvaluator& rtl, const FlatJob& job,
                         const std::vector<Fragment>& fragments) {
  const reference::StoredTexture& texture = job.hardware.texture;
  FrameResult frame;
  frame.pixels.reserve(fragments.size());
  frame.cycles.reserve(fragments.size());
  const auto texel = [&](std::uint64_t n) {
    return texel_of(fragments[n], texture.width, texture.height);
  };
  const RtlEvaluator::Sink sink = [&](std::uint64_t, const RtlPixel& pixel, std::uint64_t cycle) {
    frame.pixels.push_back({pixel.lum, pixel.out, pixel.lum_saturated, pixel.color_saturated});
    frame.cycles.push_back(cycle);
  };
  // The words come from software, as fast as the pipeline's ideal memory lets them.
  const contract::FormatRow& format = reference::format_row(reference::map_format(texture.rgb));
  const auto passes = static_cast<unsigned>(format.passes);
  const int planes = reference::map_planes(reference::map_format(texture.rgb), job.config);
  const int beats = (planes + job.tmus - 1) / job.tmus;
  const auto idle = static_cast<Cycle>(std::max(0, beats - static_cast<int>(passes)));
  const pipeline::StreamTiming timing{.idle = idle, .group = passes};
  RtlCounters counters;
  if (texture.rgb) {
    reference::RgbOperands<> operands;
    counters = rtl.stream_rgb(
        fragments.size(), timing,
        [&](std::uint64_t n) -> const auto& {
          return operands =
                     reference::rgb_operands(texture, texel(n), fragments[n].lu, fragments[n].lv);
        },
        sink);
  } else {
    reference::LrgbOperands<> operands;
    counters = rtl.stream_lrgb(
        fragments.size(), timing,
        [&](std::uint64_t n) -> const auto& {
          return operands =
                     reference::lrgb_operands(texture, texel(n), fragments[n].lu, fragments[n].lv);
        },
        sink);
  }
  frame.first_operand = idle;
  frame.total_cycles = frame.evaluator_cycles = counters.cycles;
  frame.multiplies = counters.beats * (format.multiplies / passes);
  frame.input_stalled = counters.input_stalled;
  frame.output_blocked = counters.output_blocked;
  return frame;
}

void simulate_rtl(const FlatJob& job, ResultFile& file) {
  const auto rtl = make_rtl_evaluator(job.config);
  double seconds = 0;
  for (const golden::Light& light : job.lights) {
    const std::vector<Fragment> fragments = make_fragments(job, job.config, light);
    const Stopwatch watch;
    const FrameResult frame = stream_frame(*rtl, job, fragments);
    seconds += watch.seconds();
    put_frame(file, frame, fragments.size());
  }
  file.put(seconds);
}

}  // namespace

ChildProcess start_pipeline(const FlatJob& job) {
  return {"the pipeline model", [&](ResultFile& file) { simulate_pipeline(job, file); }};
}

ChildProcess start_rtl(const FlatJob& job) {
  return {"the RTL model", [&](ResultFile& file) { simulate_rtl(job, file); }};
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
    if (model != "rtl" || kCounters[i].evaluators) {
      timed.model.counters.push_back({kCounters[i].name, totals[i]});
    }
  }
  timed.model.cycles = totals[2];
  return timed;
}

}  // namespace ptm::testbench
