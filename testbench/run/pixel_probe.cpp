#include "testbench/run/pixel_probe.h"

#include "testbench/rtl/verilated_evaluator.h"
#include "testbench/run/golden_trace.h"
#include "testbench/run/hardware_trace.h"

namespace ptm::testbench {
namespace {

using reference::Fragment;
using reference::LrgbOperands;
using reference::RgbOperands;
using IntegerValues = std::vector<IntegerValue>;

void append(IntegerValues& values, IntegerValues more) {
  values.insert(values.end(), more.begin(), more.end());
}

IntegerValues reference_values(const FlatJob& job, const LrgbOperands<>& in) {
  return trace_values(reference::evaluate_lrgb(job.config, in));
}

IntegerValues reference_values(const FlatJob& job, const RgbOperands<>& in) {
  return trace_values(reference::evaluate_rgb(job.config, in));
}

/// The RTL's stage registers as the operands pass through them.
IntegerValues rtl_values(const FlatJob& job, const LrgbOperands<>& in) {
  const RtlTrace trace = make_rtl_evaluator(job.config)->trace(in);
  return trace_values(reference::LrgbTrace<>{trace.luminance, trace.product, trace.color});
}

IntegerValues rtl_values(const FlatJob& job, const RgbOperands<>& in) {
  const auto passes = make_rtl_evaluator(job.config)->trace(in);
  reference::RgbTrace<> trace;
  for (std::size_t c = 0; c < 3; ++c) {
    trace.channel[c] = passes[c].luminance;
    trace.color.out[c] = passes[c].color.out[c];
    trace.color.saturated |= passes[c].color.saturated;
  }
  return trace_values(trace);
}

template <class Operands>
std::vector<NamedValue> hardware_values(const FlatJob& job, const std::string& model,
                                        const Operands& in) {
  IntegerValues values = operand_values(in);
  append(values, model == "rtl" ? rtl_values(job, in) : reference_values(job, in));
  std::vector<NamedValue> printed;
  for (const IntegerValue& value : values) {
    printed.push_back(print_value(value, job.config, in.shift));
  }
  return printed;
}

}  // namespace

PixelProbe make_probe(std::shared_ptr<const FlatJob> job,
                      std::map<std::string, std::vector<std::vector<pipeline::Cycle>>> cycles) {
  return [job = std::move(job), cycles = std::move(cycles)](const std::string& model, int frame,
                                                            int x, int y) {
    const golden::Light& light = job->lights[static_cast<std::size_t>(frame)];
    const Fragment f = make_fragment(*job, job->config, light, x, y);
    const std::size_t texel = texel_of(f, job->map.width, job->map.height);
    if (model == "golden") return golden_values(job->map, texel, light);
    const reference::StoredTexture& texture = job->hardware.texture;
    auto values =
        texture.rgb
            ? hardware_values(*job, model, reference::rgb_operands(texture, texel, f.lu, f.lv))
            : hardware_values(*job, model, reference::lrgb_operands(texture, texel, f.lu, f.lv));
    const auto timed = cycles.find(model);
    if (timed != cycles.end()) {
      const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(job->width) +
                         static_cast<std::size_t>(x);
      values.push_back({"leaves in cycle (from the first operand)",
                        std::to_string(timed->second[static_cast<std::size_t>(frame)][pixel])});
    }
    return values;
  };
}

}  // namespace ptm::testbench
