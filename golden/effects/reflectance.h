#pragma once

namespace ptm::golden {

/// Fresnel's reflectance of unpolarised light from air, exactly, for an index n + i k:
///
///     g^2 = n^2 - k^2 - s^2,  s^2 = 1 - c^2,  p = sqrt(g^4 + 4 n^2 k^2)
///     a^2 = (p + g^2) / 2,    q = a^2 + b^2 = p
///     Rs  = (q - 2 a c + c^2) / (q + 2 a c + c^2)
///     Rp  = Rs (c^2 q - 2 a c s^2 + s^4) / (c^2 q + 2 a c s^2 + s^4),   R = (Rs + Rp) / 2
///
/// c is the cosine of incidence, limited to 0..1; n > 0, k >= 0. Result in 0..1, 1 at grazing.
/// A dielectric has k = 0.
[[nodiscard]] double reflectance(double cosine, double n, double k);

}  // namespace ptm::golden
