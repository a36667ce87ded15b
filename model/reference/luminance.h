#pragma once
#include <array>

#include "model/reference/eval_widths.h"
#include "model/reference/rounding.h"

/// One luminance: D1 to D6 of docs/spec/datapath.md, 8 multiplies and 5 adds.
namespace ptm::reference {

template <class Int>
using Six = std::array<Int, 6>;  ///< a0 (lu^2), a1 (lv^2), a2 (lu lv), a3 (lu), a4 (lv), a5 (1)

/// {f(0), ..., f(5)}: values, not loops over arrays, so that a compiler keeps them in registers.
template <class F>
[[nodiscard, gnu::always_inline]] constexpr auto for_six(F&& f) {
  return std::array{f(0U), f(1U), f(2U), f(3U), f(4U), f(5U)};
}

/// D1. Removes the bias.
///
///     d[i] = sat(coef[i] - (bias[i] << filter_frac), delta_bits + filter_frac)
///
/// With delta_bits > coef_bits every difference fits, and sat is left out.
/// Requires  coef unsigned, coef_bits + filter_frac bits; bias unsigned, coef_bits bits.
/// Twin      rtl/evaluator/ptm_evaluator_unpack.sv
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Six<Int> unpack(const EvalConfig& config,
                                                            const Six<Int>& coef,
                                                            const Six<Int>& bias) {
  const StepScope<Int> scope(Step::unpack);
  return for_six([&](unsigned i) -> Int {
    const Int difference = coef[i] - shift_left(bias[i], config.filter_frac);
    return config.delta_bits > config.coef_bits ? difference
                                                : sat(difference, widths(config).delta);
  });
}

template <class Int = Value>
struct Basis {
  Int uu{}, vv{}, uv{};  ///< lu^2, lv^2, lu*lv with basis_frac fraction bits
};

/// D2. The quadratic basis, 3 multiplies.
///
///     uu = sat(narrow(lu * lu, 2 light_frac - basis_frac), basis_bits), likewise vv, uv
///
/// Requires  lu, lv signed codes of light_int + light_frac bits, the most negative included.
/// Error     half a unit of 2^-basis_frac (nearest), one (truncate), and one where it saturates:
///           for |lu| = |lv| = 2^(light_int - 1), and of a basis so coarse that squares of codes
///           next to it round up to its own.
/// Twin      rtl/evaluator/ptm_evaluator_basis.sv
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Basis<Int> basis(const EvalConfig& config, Int lu,
                                                             Int lv) {
  const StepScope<Int> scope(Step::basis);
  const int drop = 2 * config.light_frac - config.basis_frac;
  const int bits = widths(config).basis;
  return {sat(narrow_constant(config.rounding, Int{lu * lu}, drop), bits),
          sat(narrow_constant(config.rounding, Int{lv * lv}, drop), bits),
          sat(narrow_constant(config.rounding, Int{lu * lv}, drop), bits)};
}

/// D3. Products, 5 multiplies, exact: p0..p2 with basis_frac fraction bits, p3 and p4 with
/// light_frac, p5 with none (and filter_frac more each).  Twin:
/// rtl/evaluator/ptm_evaluator_products.sv
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Six<Int> products(const Six<Int>& d,
                                                              const Basis<Int>& b, Int lu, Int lv) {
  const StepScope<Int> scope(Step::products);
  return {d[0] * b.uu, d[1] * b.vv, d[2] * b.uv, d[3] * lu, d[4] * lv, d[5]};
}

/// D4. Brings all terms to `guard` fraction bits, each by its own shift.
///
///     t[i] = narrow(p[i], frac[i] + shift[i] - guard)
///
/// A constant left shift first makes the amount non-negative for every legal shift, so that one
/// right shifter serves both signs.
/// Requires  shift_min <= shift[i] <= 15.
/// Twin      rtl/evaluator/ptm_evaluator_align.sv
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Six<Int> align(const EvalConfig& config,
                                                           const Six<Int>& p,
                                                           const Six<Int>& shift) {
  const StepScope<Int> scope(Step::align);
  const EvalWidths w = widths(config);
  return for_six([&](unsigned i) -> Int {
    const Int amount = shift[i] + Int{Value{w.frac[i] - config.guard + w.pre_shift[i]}};
    return narrow(config.rounding, shift_left(p[i], w.pre_shift[i]), amount);
  });
}

/// D5. The sum, 5 adds, in order of the coefficients.  Twin: rtl/evaluator/ptm_evaluator_sum.sv
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Int sum(const Six<Int>& t) {
  const StepScope<Int> scope(Step::sum);
  return t[0] + t[1] + t[2] + t[3] + t[4] + t[5];
}

template <class Int = Value>
struct Luminance {
  Int lum{};        ///< unsigned, lum_bits integer and lum_frac fraction bits
  Int saturated{};  ///< 1 if the clamp changed it
};

/// D6. lum = clamp(narrow(acc, guard - lum_frac), 0, 2^(lum_bits + lum_frac) - 1)
/// Twin: rtl/evaluator/ptm_evaluator_luminance.sv
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Luminance<Int> luminance(const EvalConfig& config,
                                                                     Int acc) {
  const StepScope<Int> scope(Step::luminance);
  const Int exact = narrow_constant(config.rounding, acc, config.guard - config.lum_frac);
  const Int top{(Value{1} << widths(config).lum) - 1};
  const Int clamped = smaller(larger(exact, Int{Value{0}}), top);
  return {clamped, differs(clamped, exact)};
}

/// Every intermediate value of one luminance, named as in the contract.
template <class Int = Value>
struct LuminanceTrace {
  Six<Int> d{};
  Basis<Int> b{};
  Six<Int> p{}, t{};
  Int acc{};
  Luminance<Int> lum{};
};

/// D1 to D6. Values outside the stated ranges are the caller's error.
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr LuminanceTrace<Int> evaluate_luminance(
    const EvalConfig& config, const Six<Int>& coef, const Six<Int>& bias, const Six<Int>& shift,
    Int lu, Int lv) {
  LuminanceTrace<Int> trace;
  trace.d = unpack(config, coef, bias);
  trace.b = basis(config, lu, lv);
  trace.p = products(trace.d, trace.b, lu, lv);
  trace.t = align(config, trace.p, shift);
  trace.acc = sum(trace.t);
  trace.lum = luminance(config, trace.acc);
  return trace;
}

}  // namespace ptm::reference
