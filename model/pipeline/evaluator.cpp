#include "model/pipeline/evaluator.h"

#include <algorithm>

namespace ptm::pipeline {
namespace {

template <class To, class From>
std::array<To, 3> narrow_to(const std::array<From, 3>& values) {
  return {static_cast<To>(values[0]), static_cast<To>(values[1]), static_cast<To>(values[2])};
}

}  // namespace

Evaluator::Evaluator(const sc_core::sc_module_name& name, const reference::EvalConfig& config)
    : sc_module(name), config_(config) {
  in.bind(*this);
}

void Evaluator::reset() {
  time_ = {};
  assembled_ = {};
  counters_ = {};
}

/// Computes the beat's values; true if it completes a pixel.
bool Evaluator::shade(const EvaluatorBeat& beat) {
  Pixel& pixel = assembled_.pixel;
  if (beat.channel == 0) assembled_ = {beat.id, {}};
  const auto lum =
      reference::evaluate_luminance(config_, beat.coef, beat.bias, beat.shift, beat.lu, beat.lv)
          .lum;
  const auto level = static_cast<std::uint16_t>(lum.lum);
  if (beat.rgb_map) {
    pixel.lum[beat.channel] = level;
  } else {
    pixel.lum.fill(level);
  }
  pixel.lum_saturated = pixel.lum_saturated || lum.saturated != 0;
  if (beat.rgb_map && beat.channel < 2) return false;
  const auto color =
      beat.rgb_map ? reference::color_direct(config_, narrow_to<reference::Value>(pixel.lum))
                   : reference::color_scale(config_, reference::color_products(lum.lum, beat.rgb));
  pixel.out = narrow_to<std::uint8_t>(color.out);
  pixel.color_saturated = color.saturated != 0;
  return true;
}

Cycle Evaluator::accept(const EvaluatorBeat& beat, Cycle offered) {
  const bool completes = shade(beat);
  const Cycle taken = time_.accept(
      completes, offered, [&](Cycle at_output) { return out->accept(assembled_, at_output); });
  if (counters_.beats == 0) counters_.first_accepted = taken;
  ++counters_.beats;
  counters_.multiplies += beat.rgb_map ? 8 : 11;
  counters_.input_stalled += taken - offered;
  return taken;
}

}  // namespace ptm::pipeline
