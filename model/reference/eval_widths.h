#pragma once
#include <algorithm>
#include <array>

#include "model/reference/eval_config.h"

namespace ptm::reference {

/// Every width of the datapath, derived from the configuration. All values are signed two's
/// complement unless "unsigned" is said. Twin: the functions of rtl/ptm_pkg.sv; compared by
/// tests/rtl/constants_test.cpp.
struct EvalWidths {
  int stored;                     ///< unsigned: a coefficient or bias with its filter fraction
  int delta;                      ///< D1
  int light;                      ///< a light code
  int basis;                      ///< D2
  std::array<int, 6> product;     ///< D3, p5 = d5
  std::array<int, 6> frac;        ///< fraction bits of p[i], filter fraction included
  std::array<int, 6> pre_shift;   ///< D4: constant left shift before the variable right shift
  std::array<int, 6> amount_max;  ///< D4: largest right shift, at shift = 15
  int term;                       ///< D4
  int sum;                        ///< D5
  int lum;                        ///< D6, unsigned
  int color_product;              ///< D7, unsigned: lum * rgb before narrowing
};

/// Derivation.
///  basis    the largest square, (-2^(light_int-1))^2 = 2^(2 light_int - 2), just does not fit
///           2 light_int - 1 integer bits with sign: D2 saturates it, as the contract says.
///  product  n-bit times m-bit signed fits n + m bits; its magnitude is at most 2^(n+m-2).
///  term     with k = frac + shift_min - guard the fewest dropped bits, |t| <= 2^e where
///           e = product - 2 - k for p0..p4 and delta - 1 - k for p5; rounding cannot pass a power
///           of two, but reaches it, and it reaches 1 when e < 0. [-2^e, 2^e] takes e + 2 bits.
///  sum      six terms: |acc| <= 6 * 2^e < 2^(e+3) takes e + 4 bits.
[[nodiscard]] constexpr EvalWidths widths(const EvalConfig& c) {
  EvalWidths w{};
  w.stored = c.coef_bits + c.filter_frac;
  w.delta = c.delta_bits + c.filter_frac;
  w.light = c.light_int + c.light_frac;
  w.basis = 2 * c.light_int - 1 + c.basis_frac;
  int exponent = 0;
  for (unsigned i = 0; i < 6; ++i) {
    const int operand = i < 3 ? w.basis : i < 5 ? w.light : 0;
    w.product[i] = w.delta + operand;
    w.frac[i] = c.filter_frac + (i < 3 ? c.basis_frac : i < 5 ? c.light_frac : 0);
    const int fewest_dropped = w.frac[i] + c.shift_min - c.guard;
    w.pre_shift[i] = std::max(0, -fewest_dropped);
    w.amount_max[i] = w.frac[i] + kShiftMax - c.guard + w.pre_shift[i];
    const int magnitude = i < 5 ? w.product[i] - 2 : w.delta - 1;
    exponent = std::max(exponent, magnitude - fewest_dropped);
  }
  w.term = exponent + 2;
  w.sum = exponent + 4;
  w.lum = c.lum_bits + c.lum_frac;
  w.color_product = w.lum + 8 + c.filter_frac;
  return w;
}

}  // namespace ptm::reference
