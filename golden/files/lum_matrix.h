#pragma once
#include <array>

namespace ptm::golden {

/// The colour matrix of JFIF 1.02, for LUM maps that bring none of their own.
///
///     (R, G, B, 1) = matrix * (Cr, Y, Cb, 1), row major, chroma as stored bytes
///     R = Y + 1.402 (Cr - 128)
///     G = Y - 0.344136 (Cb - 128) - 0.714136 (Cr - 128)
///     B = Y + 1.772 (Cb - 128)
///
/// The fourth column carries the offsets that the 128 brings.
[[nodiscard]] constexpr std::array<double, 16> jfif_lum_matrix() {
  return {1.402,     1, 0,         -128 * 1.402,                 //
          -0.714136, 1, -0.344136, 128 * (0.714136 + 0.344136),  //
          0,         1, 1.772,     -128 * 1.772,                 //
          0,         0, 0,         1};
}

}  // namespace ptm::golden
