#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "contract/counters.h"
#include "model/reference/unit/draw.h"

namespace ptm::reference {

using contract::kUnitCounters;
/// Counter numbers of docs/spec/unit-timing.md, the registers' order: contract/counters.toml.
using contract::UnitCounter;

/// Names, in order.
[[nodiscard]] constexpr const std::array<std::string_view, kUnitCounters>& unit_counter_names() {
  return contract::kUnitCounterNames;
}

/// The first of those that each draw has for each of its textures: hits, then misses.
inline constexpr auto kFirstTextureCounter = UnitCounter::hits_d0_map;
static_assert(static_cast<int>(UnitCounter::misses_d3_color) ==
              static_cast<int>(kFirstTextureCounter) + 4 * kDraws - 1);

/// Whether a unit of those parameters has that counter, n < kUnitCounters. One that it has not
/// reads as 0 in every model. (multiplies_effects is 0 in a unit without stages and is had all the
/// same.)
[[nodiscard]] constexpr bool has_counter(const UnitConfig& unit, UnitCounter n) {
  return unit.counters && contract::built_counter(unit, n);
}
[[nodiscard]] constexpr bool has_counter(const UnitConfig& unit, std::size_t n) {
  return has_counter(unit, static_cast<UnitCounter>(n));
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
    return static_cast<std::size_t>(static_cast<int>(kFirstTextureCounter) + 4 * draw +
                                    2 * texture);
  }
};

}  // namespace ptm::reference
