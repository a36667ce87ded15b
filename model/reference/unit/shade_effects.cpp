// A fragment with all that effects add to it, step by step: docs/spec/effects.md.
#include <algorithm>

#include "model/reference/effects/stages.h"
#include "model/reference/unit/failed_lines.h"
#include "model/reference/unit/shade_steps.h"

namespace ptm::reference {
namespace {

/// X1: the extra passes, each a luminance; flags are dropped.
template <class Config>
void evaluate_extra(const Config& constant, const Draw& draw, const UnitFragment& fragment,
                    ShadeTrace& trace) {
  const EvalConfig& config = constant;
  for (std::size_t k = 0; k < static_cast<std::size_t>(draw.effects.passes); ++k) {
    const ExtraPass& pass = draw.effects.pass[k];
    const auto set = static_cast<std::size_t>(pass.set);
    const Six<Value>& bias = set == 0 ? draw.bias : draw.effects.bias[set - 1];
    const Six<Value>& shift = set == 0 ? draw.shift : draw.effects.shift[set - 1];
    const std::size_t first = set == 0 ? 0 : kSetField + 6 * (set - 1);
    Six<Value> coef{};
    for (std::size_t i = 0; i < coef.size(); ++i) {
      coef[i] = fragment.lit ? trace.filtered[first + i] : shift_left(bias[i], config.filter_frac);
    }
    const Value lu = pass.half ? fragment.hu : fragment.lu;
    const Value lv = pass.half ? fragment.hv : fragment.lv;
    trace.value[k] = evaluate_luminance<Value>(config, coef, bias, shift, lu, lv).lum.lum;
  }
}

/// X2 and on: the stages that act on the draw.
void add_effects(const EvalConfig& config, const UnitState& state, const UnitFragment& fragment,
                 ShadeTrace& trace) {
  static constexpr EffectTable kNoTable{};
  const bool has_table = fragment.draw < state.tables.size();
  const EffectTable& table = has_table ? state.tables[fragment.draw] : kNoTable;
  const effects::StageInput<> in{config, state.draws[fragment.draw], table, trace.value};
  effects::StagePixel<> pixel;
  std::copy(trace.pixel.rgb.begin(), trace.pixel.rgb.end(), pixel.rgb.begin());
  effects::apply_stages(in, pixel);
  for (std::size_t c = 0; c < pixel.rgb.size(); ++c) {
    trace.pixel.rgb[c] = static_cast<std::uint8_t>(pixel.rgb[c]);
  }
  trace.addend = pixel.addend;
}

}  // namespace

ShadeTrace shade_trace(const EvalConfig& config, const UnitState& state,
                       const UnitFragment& fragment) {
  return with_constant_config(config, [&](const auto& constant) {
    auto trace = shading::shade_with<ShadeTrace>(constant, state, fragment);
    evaluate_extra(constant, state.draws[fragment.draw], fragment, trace);
    add_effects(config, state, fragment, trace);
    trace.pixel.memory_failed = fetches_failed_line(config, state, fragment);
    return trace;
  });
}

}  // namespace ptm::reference
