#pragma once
#include <cstdint>

namespace ptm::tests {

// A second, slower way to the datapath's roundings, written with 128-bit division instead of
// shifts, so that the same mistake is unlikely to be made twice.
__extension__ typedef __int128 Wide;

constexpr Wide floor_divide(Wide a, Wide b) {
  const Wide q = a / b;
  return (a % b != 0 && ((a < 0) != (b < 0))) ? q - 1 : q;
}

/// floor(x / 2^k + 1/2), k of either sign.
constexpr Wide round_scaled(Wide x, int k, bool nearest) {
  if (k <= 0) return x * (Wide{1} << -k);
  const Wide unit = Wide{1} << k;
  return nearest ? floor_divide(2 * x + unit, 2 * unit) : floor_divide(x, unit);
}

constexpr Wide limit(Wide x, Wide low, Wide high) { return x < low ? low : x > high ? high : x; }

}  // namespace ptm::tests
