#pragma once
#include <array>
#include <cstdint>

#include "model/reference/eval_config.h"
#include "model/reference/fragment.h"
#include "model/reference/luminance.h"
#include "model/reference/texel_format.h"
#include "model/reference/unit/unit_config.h"

/// Draw descriptors: docs/spec/unit.md, "Draw descriptor". Enumerators are the registers' codes.
namespace ptm::reference {

using contract::kDraws;
using contract::kLevelsMax;
using contract::kLineBits;

using contract::Combine;
using contract::Mip;
using contract::Wrap;

/// One texture as the unit addresses it.
struct TextureLevels {
  int width = 1, height = 1;  ///< of level 0; level l is max(1, W >> l)
  int levels = 1;
  std::array<std::uint32_t, kLevelsMax> base{};  ///< line address of each level
  bool operator==(const TextureLevels&) const = default;

  [[nodiscard]] constexpr int level_width(int l) const { return level_side(width, l); }
  [[nodiscard]] constexpr int level_height(int l) const { return level_side(height, l); }
  [[nodiscard]] static constexpr int level_side(int side, int l) {
    return (side >> l) > 1 ? side >> l : 1;
  }
};

inline constexpr int kExtraSets = contract::kExtraSetsMax;
inline constexpr int kExtraPasses = contract::kExtraPassesMax;

/// An evaluator pass beyond the map's own: docs/spec/effects.md, "Draw".
struct ExtraPass {
  int set = 0;        ///< 0: the map's polynomial; s: extra set s - 1
  bool half = false;  ///< with (hu, hv) instead of (lu, lv)
  bool operator==(const ExtraPass&) const = default;
};

/// What effects add to a draw.
struct DrawEffects {
  int sets = 0;  ///< coefficient sets of a texel beyond the map's
  std::array<Six<Value>, kExtraSets> bias{}, shift{};
  int passes = 0;
  std::array<ExtraPass, kExtraPasses> pass{};
  unsigned stages = 0;         ///< mask of the stages that act on the draw's pixels
  std::uint32_t argument = 0;  ///< what stages want to know
  bool operator==(const DrawEffects&) const = default;
};

struct Draw {
  TextureFormat format = TextureFormat::lrgb;
  bool bilinear = true;
  Mip mip = Mip::none;
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  Combine combine = Combine::none;
  bool color = false;   ///< a colour texture is fetched
  Value color_lod = 0;  ///< Q5.8, added to lod for the colour texture
  TextureLevels map, color_texture;
  Six<Value> bias{}, shift{};
  int palette = 0;
  Value ka = 0, kd = 256, ks = 0;  ///< Q1.8
  DrawEffects effects;
  bool operator==(const Draw&) const = default;
};

/// Planes of the map's array of lines: its own and those of each extra set, two or three.
[[nodiscard]] constexpr int array_planes(const Draw& draw, const EvalConfig& config) {
  return map_planes(draw.format, config) + polynomial_words(config) * draw.effects.sets;
}
/// Words of a draw: the map's planes, then the colour texture, then the sets' planes.
[[nodiscard]] constexpr int draw_words(const Draw& draw, const EvalConfig& config) {
  return array_planes(draw, config) + (draw.color ? 1 : 0);
}
/// Evaluator passes of one fragment that are the map's own.
[[nodiscard]] constexpr int draw_passes(const Draw& draw) { return format_row(draw.format).passes; }
/// Ports of the palette whose index a map's word holds; 0 for formats without one.
[[nodiscard]] constexpr int palette_ports(TextureFormat format, const UnitConfig& unit) {
  switch (format_row(format).palette) {
    case contract::PaletteKind::lrgb:
      return unit.palette_lrgb_ports;
    case contract::PaletteKind::rgb:
      return unit.palette_rgb_ports;
    default:
      return 0;
  }
}
/// All that effects have to do with a fragment of the draw: without, effects.md is of no concern.
[[nodiscard]] constexpr bool has_effects(const Draw& draw) {
  return draw.effects.sets != 0 || draw.effects.passes != 0 || draw.effects.stages != 0;
}

/// 64-byte lines of a level, all planes. Requires a legal size and level.
[[nodiscard]] std::uint64_t level_lines(const TextureLevels& texture, int planes, int level);

/// Error bits of `unit.md` and `effects.md`, "Legal"; 0 for a draw that a unit built so can draw
/// from a memory of that size. A texture that the draw has not is not checked; addresses are
/// checked only if all else is legal; how many planes a map has depends on the evaluator's
/// coef_bits. Takes any values. Twin: rtl/registers/ptm_registers_draw_check.sv.
enum DrawError : unsigned { kBadSize = 1, kBadLevels = 2, kBadAddress = 4, kBadControl = 8 };
[[nodiscard]] unsigned check_draw(const Draw& draw, std::uint64_t memory_lines,
                                  const UnitConfig& unit = {}, const EvalConfig& config = {});

}  // namespace ptm::reference
