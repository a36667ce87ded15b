#pragma once
#include "model/reference/constant_config.h"
#include "model/reference/evaluate.h"
#include "model/reference/unit/shade_filter.h"

/// Steps U10 to U11 and the fragment without effects, for shade.cpp and shade_effects.cpp alone.
namespace ptm::reference::shading {
namespace {

/// U10: operands of the passes, C and its alpha.
template <class Config, class Trace>
void make_operands(const Config& constant, const Draw& draw, bool lit, Trace& trace) {
  const EvalConfig& config = constant;
  const bool map = draw.format != TextureFormat::none;
  const auto passes = static_cast<unsigned>(draw_passes(draw));
  for (unsigned p = 0; p < passes; ++p) {
    for (unsigned i = 0; i < 6; ++i) {
      const Value dark = map ? shift_left(draw.bias[i], config.filter_frac) : 0;
      trace.coef[p][i] = lit ? trace.filtered[6 * p + i] : dark;
    }
  }
  for (unsigned c = 0; c < 4; ++c) {
    trace.color[c] =
        narrow_constant(config.rounding, trace.filtered[kColorField + c], config.filter_frac);
  }
}

/// D1 to D7: P and the flags.
template <class Config, class Trace>
void evaluate(const Config& config, const Draw& draw, const UnitFragment& fragment, Trace& trace) {
  const bool map = draw.format != TextureFormat::none;
  const Six<Value> bias = map ? draw.bias : Six<Value>{};
  const Six<Value> shift = map ? draw.shift : Six<Value>{};
  const Value lu = fragment.lu, lv = fragment.lv;
  if (draw_passes(draw) == 3) {
    const RgbTrace<> out =
        evaluate_rgb<Value>(config, RgbOperands<>{trace.coef, bias, shift, lu, lv});
    trace.lit = out.color.out;
    trace.pixel.lum_saturated = out.lum_saturated != 0;
    trace.pixel.color_saturated = out.color.saturated != 0;
    return;
  }
  const Three<Value> rgb{trace.filtered[18], trace.filtered[19], trace.filtered[20]};
  const LrgbTrace<> out =
      evaluate_lrgb<Value>(config, LrgbOperands<>{trace.coef[0], bias, shift, rgb, lu, lv});
  trace.lit = out.color.out;
  trace.pixel.lum_saturated = out.luminance.lum.saturated != 0;
  trace.pixel.color_saturated = out.color.saturated != 0;
}

/// U11 and the alpha of U10.
template <class Config, class Trace>
void combine(const Config& constant, const Draw& draw, Trace& trace) {
  const EvalConfig& config = constant;
  for (unsigned c = 0; c < 3; ++c) {
    const CombineOperands<> in{trace.lit[c], trace.color[c], trace.color[3], draw.ka, draw.kd};
    trace.pixel.rgb[c] =
        static_cast<std::uint8_t>(combine_channel(config.rounding, draw.combine, in));
  }
  Value alpha = 255;
  if (format_row(draw.format).alpha) {
    alpha = narrow_constant(config.rounding, trace.filtered[kMapAlphaField], config.filter_frac);
  }
  if (draw.combine == Combine::replace) alpha = trace.color[3];
  trace.pixel.alpha = static_cast<std::uint8_t>(alpha);
}

/// U1 to U11.
template <class Trace, class Config>
Trace shade_with(const Config& config, const UnitState& state, const UnitFragment& fragment) {
  const Draw& draw = state.draws[fragment.draw];
  Trace trace;
  trace.pixel.x = fragment.x;
  trace.pixel.y = fragment.y;
  trace.filtered = filter_fragment<decltype(trace.filtered)>(config, state, draw, fragment);
  make_operands(config, draw, fragment.lit, trace);
  evaluate(config, draw, fragment, trace);
  combine(config, draw, trace);
  return trace;
}

}  // namespace
}  // namespace ptm::reference::shading
