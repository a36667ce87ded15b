#include "model/reference/unit/beats.h"

#include <algorithm>

namespace ptm::reference {
namespace {

constexpr Value kLodMax = 4095;

bool has_texture(const Draw& draw, int texture) {
  return texture == 0 ? draw.format != TextureFormat::none : draw.color;
}

}  // namespace

LevelChoice choose_level(const Draw& draw, const UnitFragment& fragment, int texture) {
  if (!has_texture(draw, texture)) return {0, 0};
  if (texture == 0) return choose_level(draw.mip, fragment.lod, draw.map.levels);
  const Value lod = std::clamp<Value>(Value{fragment.lod} + draw.color_lod, 0, kLodMax);
  return choose_level(draw.mip, lod, draw.color_texture.levels);
}

Columns scale_coordinate(Wrap wrap, bool bilinear, Value wrapped, int size) {
  const TexelPosition<Value> at = texel_position(bilinear, wrapped, Value{size});
  const auto index = static_cast<std::int32_t>(at.index);
  return {neighbour(wrap, index, size), neighbour(wrap, index + 1, size),
          static_cast<int>(at.weight)};
}

int footprint_count(const Draw& draw, const UnitFragment& fragment) {
  const bool two =
      choose_level(draw, fragment, 0).weight != 0 || choose_level(draw, fragment, 1).weight != 0;
  return two ? 2 : 1;
}

Footprint make_footprint(const Draw& draw, const UnitFragment& fragment, int texture, int probe,
                         int footprint) {
  const LevelChoice choice = choose_level(draw, fragment, texture);
  Footprint out;
  out.level_weight = choice.weight;
  out.level = choice.level;
  if (!has_texture(draw, texture) || (footprint == 1 && choice.weight == 0)) return out;
  out.fetched = true;
  out.level += footprint;

  const TextureLevels& levels = texture == 0 ? draw.map : draw.color_texture;
  const auto along = [&](Value u, Value axis, Wrap wrap, int size) {
    const Value moved = probe_coordinate(u, axis, probe, fragment.probes_log2);
    return scale_coordinate(wrap, draw.bilinear, wrap_coordinate(wrap, moved), size);
  };
  const Columns columns =
      along(fragment.u, fragment.axis_u, draw.wrap_u, levels.level_width(out.level));
  const Columns rows =
      along(fragment.v, fragment.axis_v, draw.wrap_v, levels.level_height(out.level));
  out.i0 = columns.i0;
  out.i1 = columns.i1;
  out.wu = columns.weight;
  out.j0 = rows.i0;
  out.j1 = rows.i1;
  out.wv = rows.weight;
  return out;
}

TexelPlace place_of(const TextureLevels& texture, int planes, int level, int plane, std::int32_t i,
                    std::int32_t j) {
  const auto across = static_cast<std::uint32_t>((texture.level_width(level) + 3) >> 2);
  const auto column = static_cast<std::uint32_t>(i), row = static_cast<std::uint32_t>(j);
  const std::uint32_t tile = (row >> 2) * across + (column >> 2);
  return {texture.base[static_cast<std::size_t>(level)] +
              tile * static_cast<std::uint32_t>(planes) + static_cast<std::uint32_t>(plane),
          (row & 3) * 4 + (column & 3)};
}

}  // namespace ptm::reference
