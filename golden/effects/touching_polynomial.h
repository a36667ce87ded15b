#pragma once
#include <array>

#include "golden/render/light_map.h"

namespace ptm::golden {

/// The polynomial that has the value, slope and curvature of N.H at H = N: 1 for full.
///
///     N.H = hu Nu + hv Nv + hw Nw,  hw = sqrt(1 - hu^2 - hv^2)
///     L   = 1 - d^T (I + m m^T / w^2) d / 2,   d = (hu, hv) - m,  m = (Nu, Nv),  w = Nw
///
/// Raised to a power only the neighbourhood of N counts, and there nothing of second order is
/// nearer; the fits over all lights (golden/bump) are flat-topped or miss N. Figures:
/// docs/design/effects.md. w counts as at least kSteepest, so that coefficients stay within 5:
/// flatter highlights on texels that lean more than 60 degrees, still greatest at N.
[[nodiscard]] Coefficients touching_polynomial(const std::array<double, 3>& normal);
inline constexpr double kSteepest = 0.5;

}  // namespace ptm::golden
