#pragma once
#include "model/reference/color.h"
#include "model/reference/unit/draw.h"

namespace ptm::reference {

template <class Int = Value>
struct CombineOperands {
  Int lit{};          ///< P, 0..255
  Int color{};        ///< C, 0..255
  Int color_alpha{};  ///< Ca, 0..255
  Int ka{}, kd{};     ///< Q1.8, 0..511
};

/// U11 of docs/spec/unit.md, one channel.
///
///     none      P                                modulate  div255(P C)
///     decal     div255(C Ca + P (255 - Ca))      blend     min(255, narrow(kd P + ka C, 8))
///     add       min(255, P + C)                  replace   C
///
/// div255 is D7's division; its arguments are at most 255^2, so it needs no limit here.
/// Multiplies  modulate 1, decal and blend 2, others none
/// Error       half a level (nearest), one (truncate), before the limit
/// Twin        rtl/back/ptm_back_combine.sv
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Int combine_channel(Rounding rounding, Combine combine,
                                                                const CombineOperands<Int>& in) {
  const StepScope<Int> scope(Step::combine);
  const Int top{Value{255}};
  switch (combine) {
    case Combine::modulate:
      return divide_255(rounding, in.lit * in.color);
    case Combine::decal:
      return divide_255(rounding, in.color * in.color_alpha + in.lit * (top - in.color_alpha));
    case Combine::blend:
      return smaller(narrow(rounding, in.kd * in.lit + in.ka * in.color, Value{8}), top);
    case Combine::add:
      return smaller(in.lit + in.color, top);
    case Combine::replace:
      return in.color;
    case Combine::none:
      break;
  }
  return in.lit;
}

}  // namespace ptm::reference
