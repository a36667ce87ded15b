#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "golden/files/ptm_map.h"
#include "model/reference/unit/unit_memory.h"
#include "testbench/run/hardware_map.h"
#include "testbench/run/map_parts.h"

/// Maps and pictures as the whole unit holds them: levels on one grid, palettes.
namespace ptm::testbench {

/// Real coefficients in levels and, where there is one polynomial, colours.
struct RealTexture {
  int width = 0, height = 0;
  RealCoefficients real;
  std::vector<std::uint8_t> color;     ///< [texel][3], one polynomial only
  std::optional<golden::PtmMap> file;  ///< where it came from one: may be taken verbatim
};
[[nodiscard]] RealTexture real_texture(const golden::PtmMap& map);

struct UnitMap {
  bool rgb = false;
  std::vector<reference::StoredTexture> levels;  ///< level 0 first; empty if palettised
  std::vector<reference::StoredPaletteMap> indexed;
  std::vector<std::uint16_t> palette;  ///< [entry][6 or 18] stored coefficients
  reference::Six<reference::Value> bias{}, shift{};
  double rms_error = 0;         ///< of level 0 as stored, or of a palette's entries
  std::uint64_t saturated = 0;  ///< coefficients of level 0 that the grid does not reach
  std::string how;              ///< one sentence for the user
};

/// Stores a map for a configuration with `levels` mip levels (1: level 0 alone), halved from the
/// real coefficients and stored on the map's one bias and shift. Colours are averaged apart, as
/// the unit filters them.
[[nodiscard]] UnitMap store_unit_map(const RealTexture& texture, int levels,
                                     const reference::EvalConfig& config,
                                     Strength strength = Strength::may_move);

/// A coefficient set of an effect (docs/spec/effects.md): one polynomial a texel,
/// [height][width][6] in levels, on a grid of its own.
[[nodiscard]] UnitMap store_unit_set(int width, int height, const std::vector<double>& coef,
                                     int levels, const reference::EvalConfig& config);

/// The same with at most `entries` polynomials (or triples), one palette for all levels.
[[nodiscard]] UnitMap store_unit_palette(const RealTexture& texture, int levels, int entries,
                                         const reference::EvalConfig& config,
                                         Strength strength = Strength::may_move);

/// A picture's levels, averages rounded to bytes.
[[nodiscard]] std::vector<reference::StoredPicture> picture_levels(
    const reference::StoredPicture& picture, int levels);

/// Levels down to 1 x 1.
[[nodiscard]] int full_levels(int width, int height);

}  // namespace ptm::testbench
