#pragma once
#include <random>
#include <string>
#include <vector>

#include "testbench/rtl/unit_variants.h"
#include "tests/reference/unit_scene.h"

/// Scenes of a few texels, for what is slow to simulate or has to be seen cycle by cycle.
namespace ptm::tests {

/// A small scene: one draw so, its texels random; `draws` of them, each of another size.
struct SmallScene {
  const char* name;
  reference::TextureFormat format = reference::TextureFormat::lrgb;
  reference::Combine combine = reference::Combine::none;
  bool bilinear = true;
  reference::Mip mip = reference::Mip::none;
  reference::Wrap wrap = reference::Wrap::repeat;
  int width = 16, height = 16;
  int probes_log2 = 0;
  bool lit = true;
  int draws = 1;
};

inline const std::vector<SmallScene>& small_scenes() {
  using enum reference::TextureFormat;
  using reference::Combine, reference::Mip, reference::Wrap;
  static const std::vector<SmallScene> scenes{
      {.name = "LrgbPoint", .bilinear = false},
      {.name = "LrgbBilinear"},
      {.name = "LrgbTrilinearMirror", .mip = Mip::linear, .wrap = Wrap::mirror},
      {.name = "LrgbNearestMipClamp", .mip = Mip::nearest, .wrap = Wrap::clamp},
      {.name = "LrgbOddSeams", .width = 15, .height = 12},
      {.name = "LrgbOneTexel", .mip = Mip::linear, .width = 1, .height = 1},
      {.name = "LrgbProbes", .mip = Mip::linear, .probes_log2 = 2},
      {.name = "LrgbUnlit", .lit = false},
      {.name = "LrgbModulate", .combine = Combine::modulate, .mip = Mip::linear},
      {.name = "LrgbDecal", .combine = Combine::decal},
      {.name = "LrgbBlend", .combine = Combine::blend},
      {.name = "LrgbReplace", .combine = Combine::replace},
      {.name = "RgbBilinear", .format = rgb},
      {.name = "RgbTrilinearAdd", .format = rgb, .combine = Combine::add, .mip = Mip::linear},
      {.name = "PaletteLrgb", .format = palette_lrgb},
      {.name = "PaletteLrgbDecal",
       .format = palette_lrgb,
       .combine = Combine::decal,
       .mip = Mip::linear},
      {.name = "PaletteRgb", .format = palette_rgb},
      {.name = "PaletteRgbAddClamp",
       .format = palette_rgb,
       .combine = Combine::add,
       .wrap = Wrap::clamp},
      {.name = "ColorOnly", .format = none, .combine = Combine::replace, .mip = Mip::linear},
      {.name = "FourDraws", .mip = Mip::linear, .draws = 4}};
  return scenes;
}

struct SmallWorld {
  reference::UnitState state;
  std::vector<reference::UnitFragment> fragments;
};

/// That scene for a unit of that variant, with what effects the unit is built for in every draw
/// that may have them, and fragments about its texels.
inline SmallWorld make_small_world(const SmallScene& scene,
                                   const testbench::RtlUnitVariant& variant,
                                   std::size_t fragments) {
  using enum reference::TextureFormat;
  const reference::EvalConfig& config = variant.config;
  std::mt19937_64 rng(std::hash<std::string>{}(scene.name));
  const auto in = [&rng](int low, int high) {
    return std::uniform_int_distribution(low, high)(rng);
  };
  const auto fill = [&in](auto& values, std::size_t count, int most) {
    values.resize(count);
    for (auto& v : values) v = static_cast<std::decay_t<decltype(v)>>(in(0, most));
  };
  constexpr std::size_t kEntries = 16;
  const int most = (1 << config.coef_bits) - 1;
  SmallWorld world;
  reference::UnitState& state = world.state;
  std::vector<std::uint16_t> coef;
  if (scene.format == palette_lrgb) {
    fill(coef, kEntries * 6, most);
    append_lrgb_palette(config, coef, 0, state.palettes);
  }
  if (scene.format == palette_rgb) {
    fill(coef, kEntries * 18, most);
    set_rgb_palette(config, coef, state.palettes);
  }
  for (int d = 0; d < scene.draws; ++d) {
    reference::Draw draw;
    draw.format = scene.format;
    draw.combine = scene.combine;
    draw.color = scene.combine != reference::Combine::none;
    draw.bilinear = scene.bilinear;
    draw.mip = scene.mip;
    draw.wrap_u = draw.wrap_v = scene.wrap;
    for (auto& b : draw.bias) b = most / 2;
    draw.shift = {3, 3, 3, 2, 2, 0};
    draw.ka = 100;
    draw.kd = 200;
    draw.ks = 150;
    const bool rgb_map = draw.format == rgb || draw.format == palette_rgb;
    if (draw.format != none) {
      draw.effects.sets = variant.unit.extra_sets;
      draw.effects.passes = rgb_map && draw.effects.sets == 0 ? 0 : variant.unit.extra_passes;
      draw.effects.stages = variant.unit.stages;
      for (int k = 0; k < draw.effects.passes; ++k) {
        draw.effects.pass[static_cast<std::size_t>(k)] = {
            in(rgb_map ? 1 : 0, draw.effects.sets), variant.unit.half_vector && in(0, 1) != 0};
      }
      for (int n = 0; n < draw.effects.sets; ++n) {
        draw.effects.bias[static_cast<std::size_t>(n)] = draw.bias;
        draw.effects.shift[static_cast<std::size_t>(n)] = draw.shift;
      }
    }
    std::vector<reference::StoredTexture> map;
    std::vector<reference::StoredPaletteMap> palette_map;
    std::vector<reference::StoredPicture> picture;
    std::vector<reference::StoredSet> sets(static_cast<std::size_t>(draw.effects.sets));
    int w = scene.width + d, h = scene.height + d;
    for (bool more = true; more; w = std::max(1, w / 2), h = std::max(1, h / 2)) {
      more = scene.mip != reference::Mip::none && std::max(w, h) > 1;
      const auto texels = static_cast<std::size_t>(w * h);
      reference::StoredTexture level{w, h, rgb_map, {}, {}, {}, {}};
      fill(level.coef, texels * (rgb_map ? 18 : 6), most);
      fill(level.color, rgb_map ? 0 : texels * 3, 255);
      map.push_back(level);
      reference::StoredPaletteMap indices{w, h, rgb_map, {}, {}};
      fill(indices.index, texels, kEntries - 1);
      fill(indices.color, rgb_map ? 0 : texels * 3, 255);
      palette_map.push_back(indices);
      reference::StoredPicture image{w, h, {}};
      fill(image.rgba, texels * 4, 255);
      picture.push_back(image);
      for (auto& set : sets) {
        reference::StoredTexture& made = set.emplace_back();
        made.width = w;
        made.height = h;
        fill(made.coef, texels * 6, most);
      }
    }
    if (draw.format == lrgb || draw.format == rgb) {
      draw.map = append_map(config, map, sets, state.memory);
    } else if (draw.format != none) {
      draw.map = append_palette_map(config, palette_map, sets, state.memory);
    }
    if (draw.color) draw.color_texture = append_picture(picture, state.memory);
    state.draws.push_back(draw);
    if (draw.effects.stages != 0) {
      state.tables.resize(state.draws.size());
      state.tables.back() = reference::effect_table(8);
    }
  }
  const int light = 1 << (config.light_int + config.light_frac - 1);
  while (world.fragments.size() < fragments) {
    reference::UnitFragment f;
    f.x = static_cast<std::uint16_t>(world.fragments.size());
    f.y = static_cast<std::uint16_t>(in(0, 16383));
    f.u = in(-(1 << 20), 2 << 20);
    f.v = in(-(1 << 20), 2 << 20);
    f.lod = static_cast<std::uint16_t>(in(0, 1) != 0 ? 0 : in(0, 1300));
    f.axis_u = in(-(1 << 17), 1 << 17);
    f.axis_v = in(-(1 << 17), 1 << 17);
    f.probes_log2 = static_cast<std::uint8_t>(scene.probes_log2);
    f.lu = in(-light, light - 1);
    f.lv = in(-light, light - 1);
    if (variant.unit.half_vector) {
      f.hu = in(-light, light - 1);
      f.hv = in(-light, light - 1);
    }
    f.lit = scene.lit;
    f.draw = static_cast<std::uint8_t>(in(0, scene.draws - 1));
    world.fragments.push_back(f);
  }
  return world;
}

/// Four draws whose beats are many and split: trilinear, two probes, on sides that are odd, every
/// second fragment where the seams meet. A reset falls into the middle of all that A0 and A3 count.
inline SmallWorld make_reset_world(const testbench::RtlUnitVariant& variant) {
  const SmallScene scene{.name = "Resets",
                         .combine = reference::Combine::modulate,
                         .mip = reference::Mip::linear,
                         .width = 15,
                         .height = 12,
                         .probes_log2 = 1,
                         .draws = 4};
  SmallWorld world = make_small_world(scene, variant, 24);
  for (std::size_t n = 0; n < world.fragments.size(); n += 2) {
    reference::UnitFragment& f = world.fragments[n];
    f.u = f.v = 50;
    f.axis_u = f.axis_v = 20;
    f.lod = 0;
  }
  return world;
}

}  // namespace ptm::tests
