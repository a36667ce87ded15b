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
  const bool known = draw.format <= contract::kLastFormat && draw.mip <= contract::kLastMip &&
                     draw.wrap_u <= contract::kLastWrap && draw.wrap_v <= contract::kLastWrap &&
                     draw.combine <= contract::kLastCombine;
  const bool needs_color = draw.combine != Combine::none;
  const bool needs_replace = draw.format == TextureFormat::none;
  const bool complete =
      (!needs_color || draw.color) && (!needs_replace || draw.combine == Combine::replace);
  return known && complete ? 0U : kBadControl;
}

bool fits(int value, int most) { return value >= 0 && value <= most; }

/// A pass that the draw runs.
bool pass_is_legal(const Draw& draw, const ExtraPass& pass, const UnitConfig& unit) {
  if (!fits(pass.set, draw.effects.sets) || (pass.half && !unit.half_vector)) return false;
  return pass.set != 0 || format_row(draw.format).polynomials == 1;
}

unsigned check_effects(const Draw& draw, const UnitConfig& unit) {
  const DrawEffects& effects = draw.effects;
  const bool built_in = fits(effects.sets, std::min(unit.extra_sets, kExtraSets)) &&
                        fits(effects.passes, std::min(unit.extra_passes, kExtraPasses)) &&
                        (effects.stages & ~unit.stages) == 0;
  if (!built_in) return kBadControl;
  if (draw.format == TextureFormat::none && effects.sets + effects.passes > 0) return kBadControl;
  for (int k = 0; k < effects.passes; ++k) {
    if (!pass_is_legal(draw, effects.pass[static_cast<std::size_t>(k)], unit)) return kBadControl;
  }
  return 0;
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

unsigned check_draw(const Draw& draw, std::uint64_t memory_lines, const UnitConfig& unit,
                    const EvalConfig& config) {
  const bool map = draw.format != TextureFormat::none;
  unsigned errors = check_control(draw) | check_effects(draw, unit);
  if (map) errors |= check_sizes(draw.map);
  if (draw.color) errors |= check_sizes(draw.color_texture);
  if (errors != 0) return errors;
  if (map) errors |= check_levels(draw.map, array_planes(draw, config), memory_lines);
  if (draw.color) errors |= check_levels(draw.color_texture, 1, memory_lines);
  return errors;
}

}  // namespace ptm::reference
