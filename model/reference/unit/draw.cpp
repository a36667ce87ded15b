#include "model/reference/unit/draw.h"

#include <algorithm>

#include "model/reference/fragment.h"

namespace ptm::reference {
namespace {

unsigned check_sizes(const TextureLevels& texture) {
  unsigned errors = 0;
  const auto bad = [](int side) { return side < 1 || side > kLargestSide; };
  if (bad(texture.width) || bad(texture.height)) errors |= kBadSize;
  const int longer = std::max(texture.width, texture.height);
  if (texture.levels < 1 || texture.levels > kLevelsMax || longer >> (texture.levels - 1) < 1) {
    errors |= kBadLevels;
  }
  return errors;
}

unsigned check_control(const Draw& draw) {
  const bool known = draw.format <= TextureFormat::palette_rgb && draw.mip <= Mip::linear &&
                     draw.wrap_u <= Wrap::clamp && draw.wrap_v <= Wrap::clamp &&
                     draw.combine <= Combine::replace;
  const bool needs_color = draw.combine != Combine::none;
  const bool needs_replace = draw.format == TextureFormat::none;
  const bool complete =
      (!needs_color || draw.color) && (!needs_replace || draw.combine == Combine::replace);
  return known && complete ? 0U : kBadControl;
}

unsigned check_levels(const TextureLevels& texture, int planes, std::uint64_t memory_lines) {
  for (int level = 0; level < texture.levels; ++level) {
    const std::uint64_t end =
        texture.base[static_cast<std::size_t>(level)] + level_lines(texture, planes, level);
    if (end > memory_lines) return kBadAddress;
  }
  return 0;
}

}  // namespace

std::uint64_t level_lines(const TextureLevels& texture, int planes, int level) {
  const auto tiles = [](int side) { return static_cast<std::uint64_t>((side + 3) >> 2); };
  return tiles(texture.level_width(level)) * tiles(texture.level_height(level)) *
         static_cast<std::uint64_t>(planes);
}

unsigned check_draw(const Draw& draw, std::uint64_t memory_lines) {
  const bool map = draw.format != TextureFormat::none;
  unsigned errors = check_control(draw);
  if (map) errors |= check_sizes(draw.map);
  if (draw.color) errors |= check_sizes(draw.color_texture);
  if (errors != 0) return errors;
  if (map) errors |= check_levels(draw.map, map_planes(draw.format), memory_lines);
  if (draw.color) errors |= check_levels(draw.color_texture, 1, memory_lines);
  return errors;
}

}  // namespace ptm::reference
