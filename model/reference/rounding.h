#pragma once
#include "model/reference/eval_config.h"
#include "model/reference/integer.h"

namespace ptm::reference {

/// Drops k fraction bits; the one place where the datapath rounds.
///
///     nearest   floor(x / 2^k + 1/2), ties toward plus infinity
///     truncate  floor(x / 2^k)
///
/// Source    docs/spec/datapath.md, narrow
/// Error     |narrow(x, k) - x / 2^k| <= 1/2 (nearest), in [0, 1) below it (truncate)
/// Requires  0 <= k <= 62 and |x| < 2^62. k may be data (D4) or a constant.
/// Twin      rtl/arith/ptm_arith_narrow.sv
template <class Int, class Amount>
[[nodiscard, gnu::always_inline]] constexpr Int narrow(Rounding rounding, Int x, Amount k) {
  const StepScope<Int> scope(Step::narrow);
  if (rounding == Rounding::nearest) return shift_right(x + half_of(k), k);
  return shift_right(x, k);
}

/// narrow for a constant k of either sign: k <= 0 is the exact x * 2^-k.
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Int narrow_constant(Rounding rounding, Int x, int k) {
  if (k <= 0) return shift_left(x, -k);
  return narrow(rounding, x, Value{k});
}

/// Clamps to the range of an n-bit two's-complement number. Twin: rtl/arith/ptm_arith_saturate.sv.
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Int sat(Int x, int bits) {
  const Value limit = Value{1} << (bits - 1);
  return smaller(larger(x, Int{-limit}), Int{limit - 1});
}

static_assert(narrow(Rounding::nearest, Value{3}, 1) == 2, "1.5 rounds up");
static_assert(narrow(Rounding::nearest, Value{-3}, 1) == -1, "-1.5 rounds up too");
static_assert(narrow(Rounding::truncate, Value{-1}, 1) == -1, "truncate is floor");
static_assert(sat(Value{128}, 8) == 127 && sat(Value{-129}, 8) == -128);

}  // namespace ptm::reference
