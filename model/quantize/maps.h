#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

/// From real coefficients to the hardware's integers: docs/spec/quantize.md, and of
/// their formats docs/spec/datapath.md. Colour bytes are not touched; they stay with the caller.
namespace ptm::quantize {

inline constexpr std::size_t kSix = 6;  ///< coefficients of a polynomial, a0 (lu^2) first

template <class Number>
using Six = std::array<Number, kSix>;

/// A map of real coefficients that somebody else owns, in levels (white = 255).
struct RealMap {
  int width = 0;
  int height = 0;
  int polynomials = 1;           ///< 1 (LRGB, LUM) or 3 (RGB)
  std::span<const double> coef;  ///< [height][width][polynomials][6], a0 first
};

enum class Origin : std::uint8_t {
  verbatim,      ///< the file's own integers
  plain,         ///< each coefficient rounded on its own
  nearest_plane  ///< the six of a polynomial rounded together
};
[[nodiscard]] std::string_view to_string(Origin origin);

enum class Dither : std::uint8_t { none, ordered, diffused };  ///< model/quantize/dither.h

/// A map as the hardware holds it:  a_i = (coef_i - bias_i) * 2^-shift_i.
///
/// 0 <= coef_i, bias_i < 2^coef_bits, and coef_i - bias_i fits delta_bits signed: D1 of the
/// datapath never saturates on a map made here.
struct StoredMap {
  int width = 0;
  int height = 0;
  int polynomials = 1;
  std::vector<std::uint16_t> coef = {};  ///< [height][width][polynomials][6], a0 first
  Six<int> bias{};
  Six<int> shift{};
  Origin origin = Origin::verbatim;
  /// Coefficients that did not fit the range of bias and shift, and were stored at its end.
  Six<std::uint64_t> saturated{};
  /// Root mean square, over texels and lights of interest, of what storing changed in the
  /// luminance, in levels; 0 for a verbatim map.
  double rms_error = 0;
  double worst_error = 0;  ///< the same of the polynomial that changed most
  Dither dither = Dither::none;
};

/// The real coefficients that a stored map stands for, [height][width][polynomials][6].
[[nodiscard]] std::vector<double> dequantize(const StoredMap& stored);

}  // namespace ptm::quantize
