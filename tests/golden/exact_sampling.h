#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "golden/render/texture_filter.h"
#include "tests/reference/exact_rational.h"

/// Which texels a sample takes and how much each counts, in whole numbers: a second way to
/// golden/render/texture_filter.h, which shares no step with it.
namespace ptm::tests {

/// numerator / 2^places, exactly the value of a double.
struct Dyadic {
  Wide numerator = 0;
  int places = 0;  ///< >= 0
};

/// Requires |value| below 2^40 and no digit below 2^-70.
inline Dyadic dyadic(double value) {
  Dyadic exact;
  for (double rest = value; rest != std::trunc(rest); rest *= 2) ++exact.places;
  exact.numerator = static_cast<Wide>(std::ldexp(value, exact.places));
  return exact;
}

/// The double nearest to k / side, by long division: 54 digits, then round half to even.
inline double nearest_double(std::int64_t k, int side) {
  if (k == 0) return 0;
  const bool negative = k < 0;
  Wide rest = negative ? -k : k;
  int exponent = 0;
  while (rest < (Wide{side} << 52)) rest *= 2, --exponent;
  while (rest >= (Wide{side} << 53)) exponent++, rest = rest / 2;  // never for k below 2^53 side
  Wide mantissa = rest / side;
  const Wide twice = 2 * (rest % side);
  if (twice > side || (twice == side && mantissa % 2 != 0)) ++mantissa;
  const double value = std::ldexp(static_cast<double>(mantissa), exponent);
  return negative ? -value : value;
}

/// The texel of the endless row: edges are at the doubles nearest to k / side.
inline std::int64_t endless_by_edges(double coordinate, int side) {
  const Dyadic exact = dyadic(coordinate);
  // Within one of the exact product; then every edge near it is asked.
  const auto about =
      static_cast<std::int64_t>(floor_divide(exact.numerator * side, Wide{1} << exact.places));
  std::int64_t k = about - 2;
  while (nearest_double(k + 1, side) <= coordinate) ++k;
  return k;
}

/// A place of the endless row brought into the texture, by counting.
inline int wrapped_texel(std::int64_t endless, int side, golden::WrapMode mode) {
  if (mode == golden::WrapMode::clamp) {
    return static_cast<int>(std::clamp<std::int64_t>(endless, 0, side - 1));
  }
  const std::int64_t period = static_cast<std::int64_t>(floor_divide(endless, side));
  const auto within = static_cast<int>(endless - period * side);
  const bool backwards = mode == golden::WrapMode::mirror && period % 2 != 0;
  return backwards ? side - 1 - within : within;
}

/// Two texels along a side and the exact share of the second.
struct ExactPair {
  std::array<int, 2> texel{};
  long double share = 0;  ///< a dyadic of at most 64 digits
};

inline ExactPair exact_pair(double coordinate, int side, golden::WrapMode mode, bool bilinear) {
  if (!bilinear) {
    const int texel = wrapped_texel(endless_by_edges(coordinate, side), side, mode);
    return {{texel, texel}, 0};
  }
  // Half a texel back: 2 u side - 1 halves, of which 2 make a texel. Beyond a clamped edge both
  // texels are the edge's, so that the clamp of the coordinate changes nothing.
  const Dyadic exact = dyadic(coordinate);
  const Wide one = Wide{1} << (exact.places + 1);
  const Wide halves = 2 * exact.numerator * side - (Wide{1} << exact.places);
  const Wide first = floor_divide(halves, one);
  const auto k = static_cast<std::int64_t>(first);
  const auto rest = static_cast<long double>(halves - first * one);
  return {{wrapped_texel(k, side, mode), wrapped_texel(k + 1, side, mode)},
          rest / static_cast<long double>(one)};
}

/// One or two levels and the exact share of the second.
struct ExactLevels {
  std::array<int, 2> level{};
  long double share = 0;
};

inline ExactLevels exact_levels(double lod, int last, golden::MipMode mode) {
  if (mode == golden::MipMode::none || lod <= 0) return {};
  if (lod >= last) return {{last, last}, 0};
  const Dyadic exact = dyadic(lod);
  const Wide one = Wide{1} << exact.places;
  if (mode == golden::MipMode::nearest) {
    const auto level = static_cast<int>(floor_divide(2 * exact.numerator + one, 2 * one));
    return {{level, level}, 0};
  }
  const auto level = static_cast<int>(floor_divide(exact.numerator, one));
  return {{level, level + 1},
          static_cast<long double>(exact.numerator - level * one) / static_cast<long double>(one)};
}

}  // namespace ptm::tests
