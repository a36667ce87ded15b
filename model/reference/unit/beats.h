#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "model/reference/unit/coordinate.h"
#include "model/reference/unit/unit_config.h"
#include "model/reference/unit/unit_fragment.h"

/// Steps U1 to U6 of docs/spec/unit.md: which texels a fragment reads.
namespace ptm::reference {

/// One texture's part of a footprint: level, weights, the two columns and rows.
struct Footprint {
  int level = 0;
  bool fetched = false;  ///< false: weight 0, or a texture the draw has not; no taps
  int level_weight = 0;  ///< f of U2; not 0: this texture has two footprints
  std::int32_t i0 = 0, i1 = 0, j0 = 0, j1 = 0;
  int wu = 0, wv = 0;                                     ///< Q0.8
  [[nodiscard]] bool columns() const { return wu != 0; }  ///< 10 and 11 are fetched
  [[nodiscard]] bool rows() const { return wv != 0; }
  /// U6: bit t is tap t.
  [[nodiscard]] unsigned taps() const {
    if (!fetched) return 0;
    return 1U | (columns() ? 2U : 0U) | (rows() ? 4U : 0U) | (columns() && rows() ? 8U : 0U);
  }
};

/// The four taps' order everywhere: 00, 10, 01, 11 (bit 0 is the column, bit 1 the row).
inline constexpr unsigned kTaps = 4;

struct LevelChoice {
  int level = 0, weight = 0;
};

/// U1, one direction. Twin: rtl/front/ptm_front_probe.sv.
[[nodiscard]] Value probe_coordinate(Value u, Value axis, int probe, int probes_log2);
/// U2, one texture. Requires lod in 0 .. 4095, levels in 1 .. 13.
[[nodiscard]] LevelChoice choose_level(Mip mip, Value lod, int levels);
/// U2, texture 0 (map, by lod) or 1 (colour, by lod + color_lod); level 0 and weight 0 of a texture
/// that the draw has not.
[[nodiscard]] LevelChoice choose_level(const Draw& draw, const UnitFragment& fragment, int texture);

/// U5: index in -1 .. size to 0 .. size - 1.
[[nodiscard]] constexpr std::int32_t neighbour(Wrap wrap, std::int32_t index, int size) {
  if (wrap != Wrap::repeat) return std::clamp(index, 0, size - 1);
  if (index < 0) return size - 1;
  return index < size ? index : 0;
}
/// U4 and U5, one direction: both indices and the weight between them. Point sampling has weight 0
/// and a neighbour all the same, which is not fetched.
struct Columns {
  std::int32_t i0 = 0, i1 = 0;
  int weight = 0;
};
[[nodiscard]] constexpr Columns scale_coordinate(Wrap wrap, bool bilinear, Value wrapped,
                                                 int size) {
  const TexelPosition<Value> at = texel_position(bilinear, wrapped, Value{size});
  const auto index = static_cast<std::int32_t>(at.index);
  return {neighbour(wrap, index, size), neighbour(wrap, index + 1, size),
          static_cast<int>(at.weight)};
}

/// How many footprints a fragment has a probe: 1 or 2.
[[nodiscard]] int footprint_count(const Draw& draw, const UnitFragment& fragment);

/// U1 to U5 of one texture (0 map, 1 colour) for one probe and footprint (0, 1).
[[nodiscard]] Footprint make_footprint(const Draw& draw, const UnitFragment& fragment, int texture,
                                       int probe, int footprint);

/// U6: line and word of a texel.
struct TexelPlace {
  std::uint32_t line = 0;
  unsigned word = 0;  ///< 0..15
  bool operator==(const TexelPlace&) const = default;
};
[[nodiscard]] constexpr TexelPlace place_of(const TextureLevels& texture, int planes, int level,
                                            int plane, std::int32_t i, std::int32_t j) {
  const auto across = static_cast<std::uint32_t>((texture.level_width(level) + 3) >> 2);
  const auto column = static_cast<std::uint32_t>(i), row = static_cast<std::uint32_t>(j);
  const std::uint32_t tile = (row >> 2) * across + (column >> 2);
  return {texture.base[static_cast<std::size_t>(level)] +
              tile * static_cast<std::uint32_t>(planes) + static_cast<std::uint32_t>(plane),
          (row & 3) * 4 + (column & 3)};
}

}  // namespace ptm::reference
