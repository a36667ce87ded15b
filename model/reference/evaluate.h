#pragma once
#include <array>

#include "model/reference/color.h"
#include "model/reference/luminance.h"

/// A whole pixel, for any configuration in the stated ranges. The datapath's functions are always
/// inlined, so that a configuration known to the compiler (constant_config.h) folds every width and
/// shift amount into the code.
namespace ptm::reference {

/// Operands of an LRGB pixel; twin of the ports of rtl/evaluator/ptm_evaluator.sv.
template <class Int = Value>
struct LrgbOperands {
  Six<Int> coef{}, bias{}, shift{};
  Three<Int> rgb{};  ///< 0..255, with filter_frac fraction bits
  Int lu{}, lv{};
};

template <class Int = Value>
struct LrgbTrace {
  LuminanceTrace<Int> luminance{};
  Three<Int> product{};
  Color<Int> color{};
};

/// D1 to D7: 11 multiplies, 5 adds.
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr LrgbTrace<Int> evaluate_lrgb(
    const EvalConfig& config, const LrgbOperands<Int>& in) {
  LrgbTrace<Int> trace;
  trace.luminance = evaluate_luminance(config, in.coef, in.bias, in.shift, in.lu, in.lv);
  trace.product = color_products(trace.luminance.lum.lum, in.rgb);
  trace.color = color_scale(config, trace.product);
  return trace;
}

/// Operands of an RGB pixel: one polynomial a channel, one bias and shift for all three.
template <class Int = Value>
struct RgbOperands {
  std::array<Six<Int>, 3> coef{};
  Six<Int> bias{}, shift{};
  Int lu{}, lv{};
};

template <class Int = Value>
struct RgbTrace {
  std::array<LuminanceTrace<Int>, 3> channel{};
  Int lum_saturated{};  ///< any channel's
  Color<Int> color{};
};

/// D1 to D6 once a channel, 24 multiplies and 15 adds: three passes through one evaluator.
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr RgbTrace<Int> evaluate_rgb(const EvalConfig& config,
                                                                       const RgbOperands<Int>& in) {
  RgbTrace<Int> trace;
  Three<Int> lum{};
  for (unsigned c = 0; c < 3; ++c) {
    trace.channel[c] = evaluate_luminance(config, in.coef[c], in.bias, in.shift, in.lu, in.lv);
    lum[c] = trace.channel[c].lum.lum;
    trace.lum_saturated = either(trace.lum_saturated, trace.channel[c].lum.saturated);
  }
  trace.color = color_direct(config, lum);
  return trace;
}

}  // namespace ptm::reference
