#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/reference/texture_words.h"
#include "model/reference/unit/draw.h"

/// What a unit draws from, and how it gets there: lines, palettes, register writes.
namespace ptm::reference {

inline constexpr std::size_t kLineWords = 16;
using Line = std::array<std::uint32_t, kLineWords>;  ///< a 4 x 4 tile of words, row by row

/// Tables of words packed as a map's planes are: docs/spec/unit.md, "Palettes".
struct Palettes {
  std::vector<std::array<std::uint32_t, 2>> lrgb;  ///< entry 256 palette + index; at most 1024
  std::vector<std::array<std::uint32_t, 6>> rgb;   ///< at most 4096
};

/// Everything that stands in memory and registers before a frame.
struct UnitState {
  std::vector<Line> memory;
  Palettes palettes;
  std::vector<Draw> draws;  ///< at most kDraws
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

/// Append a texture's levels (level 0 first, each max(1, W >> l)) to the memory; return how the
/// unit addresses them. Throws std::invalid_argument for sizes that do not agree, more than 4,096
/// texels a side, or coef_bits above 10.
TextureLevels append_map(const EvalConfig& config, std::span<const StoredTexture> levels,
                         std::vector<Line>& memory);
TextureLevels append_palette_map(std::span<const StoredPaletteMap> levels,
                                 std::vector<Line>& memory);
TextureLevels append_picture(std::span<const StoredPicture> levels, std::vector<Line>& memory);

/// Polynomials as palette entries: [entry][6] (lrgb) or [entry][18] (rgb) stored coefficients.
void append_lrgb_palette(const EvalConfig& config, std::span<const std::uint16_t> coef, int palette,
                         Palettes& palettes);
void set_rgb_palette(const EvalConfig& config, std::span<const std::uint16_t> coef,
                     Palettes& palettes);

struct RegisterWrite {
  std::uint16_t address = 0;
  std::uint32_t data = 0;
};
/// The writes that bring a unit's registers to the state; a draw's control comes last.
[[nodiscard]] std::vector<RegisterWrite> register_writes(const UnitState& state);
[[nodiscard]] std::vector<RegisterWrite> register_writes(const Draw& draw, int number);

}  // namespace ptm::reference
