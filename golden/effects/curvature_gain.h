#pragma once
#include "golden/effects/map_normals.h"

namespace ptm::golden {

/// Diffuse gain (section 4.1, method 2): a texel's polynomial with its curvature times a gain, its
/// value and its slope kept at `peak`, where the luminance is greatest.
///
///     L'(l) = L(l) + (g - 1) Q(l - peak),   Q(d) = a0 du^2 + a1 dv^2 + a2 du dv
///     a0'..a2' = g a0..a2
///     a3' = (1 - g) (2 a0 lu0 + a2 lv0) + a3
///     a4' = (1 - g) (2 a1 lv0 + a2 lu0) + a4
///     a5' = a5 - (1 - g) Q(peak)
///
/// Eq. 19, derived; its row for a4' has lu0 and lv0 swapped. Where there is a maximum inside, it
/// stays where it is and as bright as it is.
///
/// Elsewhere Q is not negative in every direction, and a gain on what bends upwards would lift the
/// polynomial above its peak. There only the part of Q that bends downwards counts: with g >= 1
/// L' <= L everywhere and L' = L at the peak, which stays the brightest. Of a minimum nothing
/// bends downwards, and it stays as it is.
[[nodiscard]] Coefficients with_curvature_gain(const Coefficients& a, const Peak& peak,
                                               double gain);

}  // namespace ptm::golden
