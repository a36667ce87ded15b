#pragma once
#include <array>

#include "model/reference/luminance.h"

/// From luminance to 8-bit colour: D7 of docs/spec/datapath.md, and the RGB map's last step.
namespace ptm::reference {

template <class Int>
using Three = std::array<Int, 3>;  ///< red, green, blue

template <class Int = Value>
struct Color {
  Three<Int> out{};  ///< 0..255
  Int saturated{};   ///< 1 if any channel was limited to 255
};

/// D7, products: lum * rgb[c], 3 multiplies, exact.  Twin:
/// rtl/evaluator/ptm_evaluator_color_products.sv
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Three<Int> color_products(Int lum,
                                                                      const Three<Int>& rgb) {
  const StepScope<Int> scope(Step::color_products);
  return {lum * rgb[0], lum * rgb[1], lum * rgb[2]};
}

/// x / 255 without a divider, before the limit to 255.
///
///     nearest   t = p + 128, (t + (t >> 8)) >> 8     = floor(p / 255 + 1/2)
///     truncate  (p + 1 + (p >> 8)) >> 8              = floor(p / 255)
///
/// Both are exact for 0 <= p < 65,535 and at least 255 above it (proved by exhaustion over all p
/// in tests/reference/color_test.cpp).
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Int divide_255(Rounding rounding, Int p) {
  if (rounding == Rounding::nearest) {
    const Int t = p + Int{Value{128}};
    return shift_right(t + shift_right(t, Value{8}), Value{8});
  }
  return shift_right(p + Int{Value{1}} + shift_right(p, Value{8}), Value{8});
}

/// {f(0), f(1), f(2)}, as for_six().
template <class F>
[[nodiscard, gnu::always_inline]] constexpr auto for_three(F&& f) {
  return std::array{f(0U), f(1U), f(2U)};
}

template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Color<Int> limit_color(const Three<Int>& exact) {
  const auto limited = [&](unsigned c) -> Int { return smaller(exact[c], Int{Value{255}}); };
  const Three<Int> out = for_three(limited);
  const auto changed = [&](unsigned c) { return differs(out[c], exact[c]); };
  return {out, either(either(changed(0), changed(1)), changed(2))};
}

/// D7, scale: out[c] = min(255, narrow(product[c], lum_frac + filter_frac) / 255).
/// Twin: rtl/evaluator/ptm_evaluator_color_scale.sv
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Color<Int> color_scale(const EvalConfig& config,
                                                                   const Three<Int>& product) {
  const StepScope<Int> scope(Step::color_scale);
  return limit_color<Int>(for_three([&](unsigned c) -> Int {
    const int drop = config.lum_frac + config.filter_frac;
    return divide_255(config.rounding, narrow_constant(config.rounding, product[c], drop));
  }));
}

/// RGB maps: out[c] = min(255, narrow(lum[c], lum_frac)).  Twin:
/// rtl/evaluator/ptm_evaluator_color_scale.sv
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Color<Int> color_direct(const EvalConfig& config,
                                                                    const Three<Int>& lum) {
  const StepScope<Int> scope(Step::color_scale);
  return limit_color<Int>(for_three([&](unsigned c) -> Int {
    return narrow_constant(config.rounding, lum[c], config.lum_frac);
  }));
}

}  // namespace ptm::reference
