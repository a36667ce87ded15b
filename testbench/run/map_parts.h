#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "model/quantize/palette.h"

/// What maps in files and maps in the unit's memory are made from.
namespace ptm::testbench {

/// `levels` levels of bytes [height][width][channels], the given one first; each is half the size
/// of the one above, averaged from it before its rounding to bytes.
[[nodiscard]] std::vector<std::vector<std::uint8_t>> halve_bytes(
    const std::vector<std::uint8_t>& top, int width, int height, int channels, int levels);

/// A map by a palette, on the palette's own grid.
struct PalettizedMap {
  quantize::Palette palette;
  quantize::StoredMap table;        ///< the entries, stored
  quantize::StoredMap stored;       ///< the entry of each texel
  std::vector<std::uint8_t> color;  ///< [texel][3], refitted to the entries; one polynomial only
};

/// Whether a map of one polynomial and a colour may be stored as another polynomial and a colour
/// whose product is the same. Not if the polynomial itself is asked for, as a half-vector's pass
/// does.
enum class Strength : std::uint8_t { may_move, stays };

/// Clusters polynomials as the eye sees them and stores the entries. With one polynomial a texel,
/// texels that differ in strength only share an entry and their colours make up for it, if strength
/// may move. `color` is
/// [texel][3] for one polynomial, empty for three. Throws what make_palette() does.
[[nodiscard]] PalettizedMap palettize(const quantize::RealMap& map,
                                      std::span<const std::uint8_t> color,
                                      const quantize::PaletteOptions& options,
                                      const reference::EvalConfig& config,
                                      Strength strength = Strength::may_move);

}  // namespace ptm::testbench
