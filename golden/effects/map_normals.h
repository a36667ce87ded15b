#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "golden/bump/bump_map.h"
#include "golden/render/light_map.h"
#include "golden/scene/textures.h"

/// Normals out of a map: the light of greatest luminance (section 4.1, Eq. 16-18).
namespace ptm::golden {

enum class PeakKind : std::uint8_t {
  inside,  ///< one maximum within the open disc: Eq. 16-17 hold
  rim,     ///< none there: the greatest value over the closed disc is on its rim
  ridge,   ///< determinant 0: a line of equal maxima crosses the disc
  flat     ///< no direction is brighter than another: constant, or the same all along the rim
};
struct Peak {
  std::array<double, 2> light{};  ///< where a texel is brightest, within the closed disc
  PeakKind kind = PeakKind::flat;
};

/// Where Eq. 5 is greatest over the closed unit disc. Eq. 16-17 find where its gradient is 0:
///
///     lu0 = (a2 a4 - 2 a1 a3) / D,  lv0 = (a2 a3 - 2 a0 a4) / D,  D = 4 a0 a1 - a2^2
///
/// which is that place only if D > 0 and a0 < 0 (a maximum, neither saddle nor minimum) and it lies
/// within the disc, where Eq. 18 has a real root. Else: of a ridge its point nearest to the zenith;
/// the rim's brightest point (of two alike, the first counted from lu = 1 upwards); of a flat texel
/// (0, 0).
///
/// Error     on the rim 1e-9 in the angle; D counts as 0 below 1e-12 of the squared curvature
/// Requires  finite coefficients; never NaN
[[nodiscard]] Peak brightest_light(const Coefficients& a);

/// The polynomial of a texel's luminance: LRGB its own, RGB 0.299 R + 0.587 G + 0.114 B.
[[nodiscard]] Coefficients luma_polynomial(const LoadedTexture& map, std::size_t texel);

/// A texel's unit normal (u right, v up, w to the viewer).
///
///     inside, ridge   (lu0, lv0, sqrt(1 - lu0^2 - lv0^2))                      (Eq. 18)
///     else            (a3, a4, max(0, a5)) / |.|,  (0, 0, 1) if that has no length
///
/// The second is the dot product k N.L that has the polynomial's value and slope under a light at
/// the zenith. On `dome` such texels' normals are off by 19 degrees that way and by 54 if the rim's
/// brightest point is taken for the normal (docs/design/effects.md).
[[nodiscard]] std::array<double, 3> normal_of(const Coefficients& a, const Peak& peak);

struct MapNormals {
  NormalField field;
  std::size_t without_maximum = 0;  ///< texels whose peak is not inside
};
/// Of every texel. Runs on all cores.
[[nodiscard]] MapNormals map_normals(const LoadedTexture& map);

/// "123 of 456 texels of 'name' have no maximum within the disc of lights"; empty if all have.
[[nodiscard]] std::string without_maximum_note(const LoadedTexture& map, std::size_t count);

}  // namespace ptm::golden
