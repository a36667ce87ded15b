#include "model/reference/unit/beats.h"

#include <algorithm>

namespace ptm::reference {
namespace {

constexpr Value kLodMax = 4095;

bool has_texture(const Draw& draw, int texture) {
  return texture == 0 ? draw.format != TextureFormat::none : draw.color;
}

}  // namespace

Value probe_coordinate(Value u, Value axis, int probe, int probes_log2) {
  const Value steps = 2 * Value{probe} + 1 - (Value{1} << probes_log2);
  return u + shift_right(steps * axis, Value{1});
}

LevelChoice choose_level(Mip mip, Value lod, int levels) {
  if (mip == Mip::none) return {0, 0};
  const Value last = Value{levels} - 1;
  if (mip == Mip::nearest) return {static_cast<int>(smaller((lod + 128) >> 8, last)), 0};
  const Value limited = smaller(lod, last << 8);
  return {static_cast<int>(limited >> 8), static_cast<int>(limited & 255)};
}

LevelChoice choose_level(const Draw& draw, const UnitFragment& fragment, int texture) {
  if (!has_texture(draw, texture)) return {0, 0};
  if (texture == 0) return choose_level(draw.mip, fragment.lod, draw.map.levels);
  const Value lod = std::clamp<Value>(Value{fragment.lod} + draw.color_lod, 0, kLodMax);
  return choose_level(draw.mip, lod, draw.color_texture.levels);
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

}  // namespace ptm::reference
