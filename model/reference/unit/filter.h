#pragma once
#include <array>

#include "model/reference/lerp.h"

/// Steps U7 to U9 of docs/spec/unit.md: filtering one field. Every field is filtered alone.
namespace ptm::reference {

template <class Int>
using Taps = std::array<Int, 4>;  ///< 00, 10, 01, 11

/// U7. Bilinear, 3 multiplies.
///
///     top = lerp(t00, t10, wu), bottom = lerp(t01, t11, wu), result = lerp(top, bottom, wv)
///
/// Format    taps unsigned with filter_frac fraction bits, 0 where not fetched; weights Q0.8
/// Error     below 1 unit (nearest), 2 units (truncate): one lerp's along u, one's along v
/// Twin      rtl/filter/ptm_filter_lane.sv
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Int bilinear(Rounding rounding, const Taps<Int>& taps,
                                                         Int wu, Int wv) {
  const Int top = lerp(rounding, taps[0], taps[1], wu);
  const Int bottom = lerp(rounding, taps[2], taps[3], wu);
  return lerp(rounding, top, bottom, wv);
}

/// U8 is lerp(first, second, f).

/// U9. The mean of the probes' results, their sum given; no multiply.
///
///     narrow(sum, probes_log2)
///
/// Twin      rtl/filter/ptm_filter_field.sv
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Int probe_mean(Rounding rounding, Int sum,
                                                           Int probes_log2) {
  const StepScope<Int> scope(Step::probes);
  return narrow(rounding, sum, probes_log2);
}

}  // namespace ptm::reference
