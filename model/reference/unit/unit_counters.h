#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "model/reference/unit/draw.h"

namespace ptm::reference {

/// Counter numbers of docs/spec/unit-timing.md; the registers' order.
enum class UnitCounter : std::uint8_t {
  fragments,
  pixels,
  cycles,
  cycles_moved,
  cycles_output_blocked,
  cycles_line_wait,
  cycles_ring_full,
  cycles_input_empty,
  beats,
  bank_conflicts,
  words,
  taps,
  tag_hits,
  tag_misses,
  lines_read,
  duplicate_lines,
  palette_lookups,
  multiplies_address,
  multiplies_filter,
  multiplies_eval,
  multiplies_combine,
  texture_first,  ///< of four a draw
  multiplies_effects = texture_first + 4 * kDraws
};
inline constexpr std::size_t kUnitCounters = 22 + 4 * kDraws;

/// Names, in order; from texture_first on "hits_d0_map", "misses_d0_map", "hits_d0_color", ...
[[nodiscard]] const std::array<std::string_view, kUnitCounters>& unit_counter_names();

/// Whether a unit of those parameters has that counter, n < kUnitCounters. One that it has not
/// reads as 0 in every model. (multiplies_effects is 0 in a unit without stages and is had all the
/// same.)
[[nodiscard]] constexpr bool has_counter(const UnitConfig& unit, std::size_t n) {
  return unit.counters &&
         (unit.duplicate_lines || n != static_cast<std::size_t>(UnitCounter::duplicate_lines));
}
[[nodiscard]] constexpr bool has_counter(const UnitConfig& unit, UnitCounter n) {
  return has_counter(unit, static_cast<std::size_t>(n));
}

struct UnitCounters {
  std::array<std::uint64_t, kUnitCounters> value{};
  [[nodiscard]] std::uint64_t& operator[](UnitCounter c) {
    return value[static_cast<std::size_t>(c)];
  }
  [[nodiscard]] std::uint64_t operator[](UnitCounter c) const {
    return value[static_cast<std::size_t>(c)];
  }
  /// texture 0 is the map, 1 the colour texture
  [[nodiscard]] std::uint64_t& hits(int draw, int texture) { return value[at(draw, texture)]; }
  [[nodiscard]] std::uint64_t& misses(int draw, int texture) {
    return value[at(draw, texture) + 1];
  }
  bool operator==(const UnitCounters&) const = default;

  /// Sets those to 0 that the unit has not.
  void keep_built(const UnitConfig& unit) {
    for (std::size_t n = 0; n < value.size(); ++n) {
      if (!has_counter(unit, n)) value[n] = 0;
    }
  }

 private:
  static std::size_t at(int draw, int texture) {
    return static_cast<std::size_t>(21 + 4 * draw + 2 * texture);
  }
};

}  // namespace ptm::reference
