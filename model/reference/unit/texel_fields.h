#pragma once
#include "model/reference/unit/unit_memory.h"

/// Which fields of a filtered fragment a word holds: docs/spec/unit.md, "Words" and "Steps".
namespace ptm::reference {

inline constexpr unsigned kMapColorField = 18, kMapAlphaField = 21, kColorField = 22;
inline constexpr unsigned kSetField = 26;  ///< six of each extra set from here on
inline constexpr unsigned kFields = kSetField + 6 * kExtraSets;
/// A filtered fragment: 0..17 coefficients, 18..20 the map's R G B, 21 its A, 22..25 the colour
/// texture's R G B A, 26 + 6 s + i coefficient i of set s.
using Fields = std::array<Value, kFields>;

using contract::WordKind;

/// A word of a draw.
struct WordUse {
  WordKind kind = WordKind::coefficients;
  int texture = 0;     ///< 0 map, 1 colour
  int plane = 0;       ///< within its texture
  unsigned field = 0;  ///< of coefficients and colour: the first

  /// How many fields come of it.
  [[nodiscard]] constexpr unsigned fields() const {
    return contract::kWordFields[static_cast<std::size_t>(kind)];
  }
};

/// Word 0 .. map_planes of a draw: the map's own planes in order, then the colour texture.
[[nodiscard]] constexpr WordUse own_word_use(const Draw& draw, int word) {
  const int planes = map_planes(draw.format);
  if (word == planes) return {WordKind::color, 1, 0, kColorField};
  const contract::FormatWord& own = format_row(draw.format).word[static_cast<std::size_t>(word)];
  return {own.kind, 0, word, own.field};
}

/// Plane 0 .. 2 sets - 1 of a draw's sets.
[[nodiscard]] constexpr WordUse set_word_use(const Draw& draw, int set_plane) {
  return {WordKind::coefficients, 0, map_planes(draw.format) + set_plane,
          kSetField + 3 * static_cast<unsigned>(set_plane)};
}

/// Word 0 .. draw_words - 1: the map's own planes, the colour texture, the sets' planes.
[[nodiscard]] constexpr WordUse word_use(const Draw& draw, int word) {
  const int own = map_planes(draw.format) + (draw.color ? 1 : 0);
  return word < own ? own_word_use(draw, word) : set_word_use(draw, word - own);
}

}  // namespace ptm::reference
