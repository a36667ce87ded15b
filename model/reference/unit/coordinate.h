#pragma once
#include "model/reference/fragment.h"
#include "model/reference/unit/draw.h"

/// Steps U3 and U4 of docs/spec/unit.md: from a texture coordinate to a texel and a weight.
namespace ptm::reference {

/// x mod 2^bits, of either sign: wires.
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Int low_bits(Int x, int bits) {
  return x - shift_left(shift_right(x, Value{bits}), bits);
}

/// U3. Wraps to 20 bits.
///
///     repeat  u mod 2^20
///     mirror  y = u mod 2^21: y below 2^20, else 2^21 - 1 - y (all bits inverted)
///     clamp   limited to 0 .. 2^20 - 1
///
/// Format    u signed, Q.20, of any width; the result is in 0 .. 2^20 - 1
/// Twin      rtl/front/ptm_front_wrap.sv
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr Int wrap_coordinate(Wrap wrap, Int u) {
  const StepScope<Int> scope(Step::wrap);
  if (wrap == Wrap::repeat) return low_bits(u, kCoordinateFrac);
  if (wrap == Wrap::mirror) {
    const Int both = low_bits(u, kCoordinateFrac + 1);
    return smaller(both, Int{(Value{1} << (kCoordinateFrac + 1)) - 1} - both);
  }
  return smaller(larger(u, Int{Value{0}}), Int{(Value{1} << kCoordinateFrac) - 1});
}

template <class Int = Value>
struct TexelPosition {
  Int index{};   ///< -1 .. size - 1; U5 brings it and its neighbour into the level
  Int weight{};  ///< Q0.8, of the neighbour index + 1
};

/// U4. Texel and weight along one direction, 1 multiply.
///
///     bilinear  s = ((wrapped * size + 2^11) >> 12) - 128, index s >> 8, weight s & 255
///     point     index (wrapped * size) >> 20, weight 0
///
/// Requires  wrapped in 0 .. 2^20 - 1, size in 1 .. 4096 (texels of the level)
/// Error     s is within 1/512 of a texel of wrapped * size / 2^20 - 1/2, whatever EvalConfig's
///           rounding: the half that is added makes it the nearest
/// Twin      rtl/front/ptm_front_scale.sv
template <class Int>
[[nodiscard, gnu::always_inline]] constexpr TexelPosition<Int> texel_position(bool bilinear,
                                                                              Int wrapped,
                                                                              Int size) {
  const StepScope<Int> scope(Step::scale);
  const Int product = wrapped * size;
  if (!bilinear) return {shift_right(product, Value{kCoordinateFrac}), Int{Value{0}}};
  const Int s = shift_right(product + Int{Value{1} << 11}, Value{12}) - Int{Value{128}};
  return {shift_right(s, Value{8}), low_bits(s, 8)};
}

}  // namespace ptm::reference
