#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ptm::golden {

enum class MapKind : std::uint8_t {
  lrgb,  ///< one luminance polynomial and one colour a texel (Polynomial Texture Maps, Eq. 4-5)
  rgb,   ///< one polynomial a channel (Eq. 6)
  lum,   ///< one luminance polynomial, Cr and Cb, and a colour matrix (HPL-98-131, section 3)
};

/// A polynomial texture map as a .ptm file holds it: bytes with one scale and bias a coefficient.
///
///     a_k = (coef_k - bias_k) * scale_k                                  (Eq. 7)
///     L   = a0 u^2 + a1 v^2 + a2 uv + a3 u + a4 v + a5                   (Eq. 5)
///
/// Row 0 is the top of the picture; the file's rows run bottom-up and are turned when read.
/// u points right, v points up, both in units of the unit light vector.
struct PtmMap {
  MapKind kind = MapKind::lrgb;
  int width = 0;
  int height = 0;
  std::array<double, 6> scale{1, 1, 1, 1, 1, 1};  ///< finite, not zero
  std::array<std::int32_t, 6> bias{};
  /// lum only: (R, G, B, 1) = matrix * (Cr, Y, Cb, 1), row major, chroma as stored bytes.
  std::array<double, 16> lum_matrix{};
  std::vector<std::uint8_t> coef;   ///< [height][width][polynomials()][6], a0 first
  std::vector<std::uint8_t> color;  ///< lrgb [height][width][3] R G B; lum [..][2] Cr Cb; rgb none

  [[nodiscard]] std::size_t texels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  [[nodiscard]] std::size_t polynomials() const { return kind == MapKind::rgb ? 3 : 1; }
  [[nodiscard]] std::size_t color_bytes() const {
    return kind == MapKind::lrgb ? 3 : kind == MapKind::lum ? 2 : 0;
  }
  bool operator==(const PtmMap&) const = default;
};

}  // namespace ptm::golden
