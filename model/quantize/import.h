#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "model/quantize/maps.h"
#include "model/reference/eval_config.h"

namespace ptm::quantize {

/// A file's integers, as they stand in it.
struct FileCoefficients {
  int width = 0;
  int height = 0;
  int polynomials = 1;
  std::span<const std::uint8_t> coef;  ///< [height][width][polynomials][6], a0 first
  std::array<double, 6> scale{};       ///< a_i = (coef_i - bias_i) * scale_i  (Eq. 7)
  std::array<std::int32_t, 6> bias{};
};

struct Import {
  std::optional<StoredMap> map;
  std::string why_not;  ///< empty if there is a map; otherwise what the hardware cannot hold
};

/// Takes a file's integers unchanged, where this hardware can hold them.
///
/// It can if every scale is 2^-shift with shift_min <= shift <= 15 (equal within a0 a1 a2 and
/// a3 a4 where shift_groups = 3), every bias is unsigned and fits coef_bits, every byte fits
/// coef_bits, and no coef - bias of the map leaves the range of delta_bits.
/// A byte count that is not width * height * polynomials * 6, or a configuration outside the
/// stated ranges, throws std::invalid_argument.
[[nodiscard]] Import import_verbatim(const FileCoefficients& file,
                                     const reference::EvalConfig& config);

}  // namespace ptm::quantize
