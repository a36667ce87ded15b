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
  int texture = 0;      ///< 0 map, 1 colour
  int plane = 0;        ///< within its texture
  unsigned field = 0;   ///< of coefficients and colour: the first
  unsigned fields = 0;  ///< how many come of it
};

/// Word 0 .. map_planes of a draw: the map's own planes in order, then the colour texture.
[[nodiscard]] constexpr WordUse own_word_use(const Draw& draw, const EvalConfig& config, int word) {
  const contract::FormatWords& words = format_words(draw.format, config);
  if (word == words.planes) {
    constexpr unsigned kBytes = contract::kWordFields[static_cast<std::size_t>(WordKind::color)];
    return {WordKind::color, 1, 0, kColorField, kBytes};
  }
  const contract::FormatWord& own = words.word[static_cast<std::size_t>(word)];
  return {own.kind, 0, word, own.field, own.fields};
}

/// Plane 0 .. polynomial_words * sets - 1 of a draw's sets.
[[nodiscard]] constexpr WordUse set_word_use(const Draw& draw, const EvalConfig& config,
                                             int set_plane) {
  const auto fields = static_cast<unsigned>(coefficients_a_word(config));
  return {WordKind::coefficients, 0, map_planes(draw.format, config) + set_plane,
          kSetField + fields * static_cast<unsigned>(set_plane), fields};
}

/// Word 0 .. draw_words - 1: the map's own planes, the colour texture, the sets' planes.
[[nodiscard]] constexpr WordUse word_use(const Draw& draw, const EvalConfig& config, int word) {
  const int own = map_planes(draw.format, config) + (draw.color ? 1 : 0);
  return word < own ? own_word_use(draw, config, word) : set_word_use(draw, config, word - own);
}

}  // namespace ptm::reference
