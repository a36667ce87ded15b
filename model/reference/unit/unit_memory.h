#pragma once
#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "model/reference/texture_words.h"
#include "model/reference/unit/draw.h"

/// What a unit draws from, and how it gets there: lines, palettes, register writes.
namespace ptm::reference {

inline constexpr std::size_t kLineWords = 16;
using Line = std::array<std::uint32_t, kLineWords>;  ///< a 4 x 4 tile of words, row by row

inline constexpr std::size_t kLrgbEntries = std::size_t{1} << contract::kLrgbIndexBits;
inline constexpr std::size_t kRgbEntries = std::size_t{1} << contract::kRgbIndexBits;

/// The line that the unit asks the outer memory for, for its line l: docs/spec/unit.md,
/// "Registers".
inline constexpr std::uint32_t kOuterMask = (1U << kLineBits) - 1;
[[nodiscard]] constexpr std::uint32_t outer_line(std::uint32_t base, std::uint32_t l) {
  return (base + l) & kOuterMask;
}

/// Tables of words of three coefficients, F bits each, the first in the low bits:
/// docs/spec/unit.md, "Palettes".
struct Palettes {
  std::vector<std::array<std::uint64_t, 2>> lrgb;  ///< entry 256 palette + index; at most 1024
  std::vector<std::array<std::uint64_t, 6>> rgb;   ///< at most 4096
};

using EffectTable = std::array<std::uint16_t, contract::kTableEntries>;

/// Everything that stands in memory and registers before a frame.
struct UnitState {
  std::vector<Line> memory;
  Palettes palettes;
  std::vector<Draw> draws;  ///< at most kDraws
  /// A draw's table for effect stages, 12 bits an entry (docs/spec/effects.md); of draws beyond the
  /// vector's end, all 0.
  std::vector<EffectTable> tables;
  /// Where the lines lie for the outer memory: line l at outer_line(base, l).
  std::uint32_t base = 0;
  /// Lines that the memory cannot read: it answers with an error and whatever line. Pixels of such
  /// a line are marked (UnitPixel::memory_failed), and else computed from what `memory` holds.
  std::set<std::uint32_t> failed;
};

/// A picture of R, G, B, A bytes, [height][width][4].
struct StoredPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// A palettised map: an index a texel (and for lrgb a colour), and the table.
struct StoredPaletteMap {
  int width = 0, height = 0;
  bool rgb = false;
  std::vector<std::uint16_t> index;  ///< [height][width]
  std::vector<std::uint8_t> color;   ///< [height][width][3], lrgb only
};

/// Append a texture's levels (level 0 first, each max(1, W >> l)) to the memory, level after level,
/// texels beyond an edge 0; return how the unit addresses them. A map's colours get alpha 255.
/// Throw std::invalid_argument, naming what was found and expected and leaving the memory as it
/// was, for sizes that do not agree, more than 4,096 texels a side or 2^26 lines in all, or a
/// coefficient or index that its field does not hold.
TextureLevels append_map(const EvalConfig& config, std::span<const StoredTexture> levels,
                         std::vector<Line>& memory);
TextureLevels append_palette_map(std::span<const StoredPaletteMap> levels,
                                 std::vector<Line>& memory);
TextureLevels append_picture(std::span<const StoredPicture> levels, std::vector<Line>& memory);

/// The levels of an extra coefficient set (docs/spec/effects.md), quantised as a map without
/// colours: six coefficients a texel; its colours are not looked at, bias and shift belong into the
/// draw.
using StoredSet = std::vector<StoredTexture>;

/// A map and at most four extra sets of the same levels, as one array of lines: the map's planes,
/// then those of each set, two or three. Throw as above.
TextureLevels append_map(const EvalConfig& config, std::span<const StoredTexture> levels,
                         std::span<const StoredSet> sets, std::vector<Line>& memory);
TextureLevels append_palette_map(const EvalConfig& config, std::span<const StoredPaletteMap> levels,
                                 std::span<const StoredSet> sets, std::vector<Line>& memory);

/// Polynomials as palette entries: [entry][6] (lrgb, at most 256 into palette 0..3) or [entry][18]
/// (rgb, at most 4,096) stored coefficients, red first; entries beyond them are 0. Throw
/// std::invalid_argument as above.
void append_lrgb_palette(const EvalConfig& config, std::span<const std::uint16_t> coef, int palette,
                         Palettes& palettes);
void set_rgb_palette(const EvalConfig& config, std::span<const std::uint16_t> coef,
                     Palettes& palettes);

struct RegisterWrite {
  std::uint16_t address = 0;
  std::uint32_t data = 0;
  bool operator==(const RegisterWrite&) const = default;
};
/// The writes that bring a unit's registers from reset to the state: the memory's size (an illegal
/// draw is told by it), palettes (with the upper bits of their words where those change), then each
/// draw with what effects add to it, its control last.
/// Registers of effects that are to hold 0, as after reset, are not written: a state without
/// effects has no writes of theirs. Caches and counters are not touched. Throw
/// std::invalid_argument for a value that its register's field does not hold; an illegal draw that
/// fits is written as it is.
[[nodiscard]] std::vector<RegisterWrite> register_writes(const UnitState& state);
[[nodiscard]] std::vector<RegisterWrite> register_writes(const Draw& draw, int number,
                                                         const EffectTable& table = {});

}  // namespace ptm::reference
