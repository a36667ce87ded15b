#pragma once

namespace ptm::reference {

/// What a texture unit is built with; docs/spec/unit-timing.md. The same names in rtl/ptm_unit.sv.
struct UnitConfig {
  int tmus = 3;                ///< words fetched side by side, each with a cache of its own; 1..3
  int cache_kib = 16;          ///< of one TMU; 1..64, a power of two
  int ways = 2;                ///< 1, 2, 4
  int fragment_fifo = 192;     ///< beats; 4..1024
  int miss_fifo = 64;          ///< lines reserved or outstanding; 4 * tmus..256
  int palette_lrgb_ports = 4;  ///< look-ups a cycle; 1, 2, 4
  int palette_rgb_ports = 1;   ///< 1, 2, 4
  int eval_lanes = 1;          ///< evaluators side by side; 1, or 3: one a channel
  // What effects need (docs/spec/effects.md); a unit without effects has none of it.
  int extra_sets = 0;        ///< coefficient sets of a texel beyond the map's; 0..4
  int extra_passes = 0;      ///< evaluator passes beyond the map's; extra_sets..4
  bool half_vector = false;  ///< fragments bring (hu, hv); needs extra_passes
  unsigned stages = 0;       ///< mask of effect stages behind the combine stage
  // What only tells of the unit's work (docs/spec/unit-timing.md, "Counters")
  bool counters = true;
  bool duplicate_lines = true;  ///< the counter of that name; needs counters
  bool operator==(const UnitConfig&) const = default;

  /// Sets of one tag bank.
  [[nodiscard]] constexpr int sets() const { return cache_kib * 4 / ways; }
};

/// Throws std::invalid_argument naming the first field outside its range, its value and the range.
void validate(const UnitConfig& config);

}  // namespace ptm::reference
