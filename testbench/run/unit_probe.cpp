#include "testbench/run/unit_probe.h"

#include <algorithm>
#include <sstream>

#include "model/reference/evaluate.h"
#include "model/reference/unit/shade.h"
#include "testbench/run/hardware_trace.h"

namespace ptm::testbench {
namespace {

using reference::UnitFragment;
using reference::UnitPixel;

std::string decimal(double x) {
  std::ostringstream text;
  text.precision(9);
  text << x;
  return text.str();
}

std::string q(std::int64_t code, int bits) {
  return std::to_string(code) + " (" +
         decimal(static_cast<double>(code) / static_cast<double>(1 << bits)) + ")";
}

std::vector<NamedValue> sample_values(const golden::SurfaceSample& s) {
  return {{"u", decimal(s.u)},           {"v", decimal(s.v)},
          {"lod", decimal(s.lod)},       {"axis_u", decimal(s.axis_u)},
          {"axis_v", decimal(s.axis_v)}, {"probes_log2", std::to_string(s.probes_log2)},
          {"lu", decimal(s.light[0])},   {"lv", decimal(s.light[1])},
          {"lit", s.lit ? "1" : "0"}};
}

std::vector<NamedValue> fragment_values(const UnitJob& job, const UnitFragment& f) {
  const int light = job.config.light_frac;
  return {{"u", q(f.u, 20)},           {"v", q(f.v, 20)},
          {"lod", q(f.lod, 8)},        {"axis_u", q(f.axis_u, 20)},
          {"axis_v", q(f.axis_v, 20)}, {"probes_log2", std::to_string(f.probes_log2)},
          {"lu", q(f.lu, light)},      {"lv", q(f.lv, light)},
          {"lit", f.lit ? "1" : "0"},  {"draw", std::to_string(f.draw)}};
}

void append_evaluation(const UnitJob& job, const reference::Draw& draw, const UnitFragment& f,
                       const reference::ShadeTrace& trace, std::vector<NamedValue>& values) {
  std::vector<IntegerValue> steps;
  if (reference::draw_passes(draw) == 3) {
    reference::RgbOperands<> in{trace.coef, draw.bias, draw.shift, f.lu, f.lv};
    steps = operand_values(in);
    const auto more = trace_values(reference::evaluate_rgb(job.config, in));
    steps.insert(steps.end(), more.begin(), more.end());
  } else {
    reference::LrgbOperands<> in{trace.coef[0], draw.bias, draw.shift, {}, f.lu, f.lv};
    std::copy_n(trace.filtered.begin() + 18, 3, in.rgb.begin());
    steps = operand_values(in);
    const auto more = trace_values(reference::evaluate_lrgb(job.config, in));
    steps.insert(steps.end(), more.begin(), more.end());
  }
  for (const IntegerValue& step : steps) {
    values.push_back(print_value(step, job.config, draw.shift));
  }
}

std::vector<NamedValue> reference_values(const UnitJob& job, const UnitFragment& f) {
  std::vector<NamedValue> values = fragment_values(job, f);
  const reference::Draw& draw = job.state.draws[f.draw];
  const reference::ShadeTrace trace = reference::shade_trace(job.config, job.state, f);
  if (draw.format != reference::TextureFormat::none) {
    append_evaluation(job, draw, f, trace, values);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    values.push_back({std::string("lit_") + "rgb"[c], std::to_string(trace.lit[c])});
  }
  for (std::size_t c = 0; c < 4; ++c) {
    values.push_back({std::string("color_") + "rgba"[c], std::to_string(trace.color[c])});
  }
  return values;
}

void append_pixel(const UnitPixel& pixel, std::vector<NamedValue>& values) {
  for (std::size_t c = 0; c < 3; ++c) {
    values.push_back({std::string("pixel_") + "rgb"[c], std::to_string(pixel.rgb[c])});
  }
  values.push_back({"pixel_alpha", std::to_string(pixel.alpha)});
}

}  // namespace

PixelProbe make_unit_probe(std::shared_ptr<const UnitJob> job, std::vector<UnitTimed> timed) {
  return [job = std::move(job), timed = std::move(timed)](const std::string& model, int frame,
                                                          int x, int y) {
    std::vector<NamedValue> values;
    const auto n = static_cast<std::size_t>(frame);
    const UnitFrameInput& input = job->frames[n];
    const auto found =
        std::find_if(input.samples.begin(), input.samples.end(),
                     [&](const golden::SurfaceSample& s) { return s.x == x && s.y == y; });
    if (found == input.samples.end()) return values;
    const auto index = static_cast<std::size_t>(found - input.samples.begin());
    if (model == "golden") return sample_values(*found);
    const UnitFragment& fragment = input.fragments[index];
    if (model == "rtl") {
      values = fragment_values(*job, fragment);
    } else {
      values = reference_values(*job, fragment);
      append_pixel(reference::shade(job->config, job->state, fragment), values);
    }
    for (const UnitTimed& unit : timed) {
      if (unit.model != model || n >= unit.frames.size()) continue;
      if (index >= unit.frames[n].taken.size()) continue;  // a fault came first
      if (model == "rtl") append_pixel(unit.frames[n].pixels[index], values);
      values.push_back({"leaves in cycle", std::to_string(unit.frames[n].taken[index])});
    }
    return values;
  };
}

}  // namespace ptm::testbench
