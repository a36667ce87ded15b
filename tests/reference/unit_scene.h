#pragma once
#include <algorithm>
#include <array>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "model/reference/effects/power_table.h"
#include "model/reference/effects/stages.h"
#include "model/reference/unit/unit_fragment.h"
#include "model/reference/unit/unit_memory.h"
#include "tests/reference/random_config.h"

namespace ptm::tests {

/// What a draw's memory was made from.
struct DrawSource {
  std::vector<reference::StoredTexture> map;
  std::vector<reference::StoredPaletteMap> palette_map;
  std::vector<std::vector<std::uint8_t>> map_alpha;  ///< [level][texel], LRGB only
  std::vector<reference::StoredSet> sets;            ///< of the draw's effects
  std::vector<reference::StoredPicture> color;
};

struct UnitScene {
  reference::EvalConfig config;
  reference::UnitConfig unit;  ///< built with what the draws need; all else as it is by default
  reference::UnitState state;
  std::vector<DrawSource> sources;                            ///< of each draw
  std::array<std::vector<std::uint16_t>, 4> lrgb_palettes{};  ///< [entry][6]
  std::vector<std::uint16_t> rgb_palette;                     ///< [entry][18]
};

inline std::string describe(const reference::UnitFragment& f) {
  std::ostringstream out;
  out << "u " << f.u << " v " << f.v << " axis " << f.axis_u << ' ' << f.axis_v << " lod " << f.lod
      << " probes_log2 " << int{f.probes_log2} << " light " << f.lu << ' ' << f.lv
      << " half-vector " << f.hu << ' ' << f.hv << " lit " << f.lit << " draw " << int{f.draw};
  return out.str();
}

/// Random but legal scenes, edges often: every format, wrap, filter and combine, sides from 1 to
/// 4,096 that are seldom powers of two, colour textures of a size of their own.
class UnitSceneMaker {
 public:
  /// With effects: units with any part of docs/spec/effects.md, and draws that use some of it.
  explicit UnitSceneMaker(std::uint64_t seed, bool with_effects = false)
      : rng_(seed), with_effects_(with_effects) {}

  UnitScene scene(int draws = 4) { return scene(config(), draws); }
  UnitScene scene(const reference::EvalConfig& built_for, int draws = 4) {
    UnitScene out;
    out.config = built_for;
    fill_palettes(out);
    if (with_effects_) build_effects(out.unit);
    return add_draws(std::move(out), draws);
  }
  /// With effects, of which that unit has what they need.
  UnitScene scene(const reference::EvalConfig& built_for, const reference::UnitConfig& unit,
                  int draws = 4) {
    UnitScene out;
    out.config = built_for;
    out.unit = unit;
    with_effects_ = true;
    fill_palettes(out);
    return add_draws(std::move(out), draws);
  }

  /// Any fragment of a format's range, extremes often.
  reference::UnitFragment fragment(const UnitScene& scene) {
    reference::UnitFragment f;
    f.draw = static_cast<std::uint8_t>(in(0, static_cast<int>(scene.state.draws.size()) - 1));
    const reference::Draw& draw = scene.state.draws[f.draw];
    f.u = coordinate(draw.map.width);
    f.v = coordinate(draw.map.height);
    f.axis_u = in(0, 1) != 0 ? in(-4096, 4096) : coordinate(1);
    f.axis_v = in(0, 1) != 0 ? in(-4096, 4096) : coordinate(1);
    f.lod = static_cast<std::uint16_t>(in(0, 1) != 0 ? in(0, 4095) : in(0, 16) * 64);
    f.lod = std::min<std::uint16_t>(f.lod, 4095);
    f.probes_log2 = static_cast<std::uint8_t>(in(0, 2) != 0 ? 0 : in(0, 4));
    const int light = 1 << (scene.config.light_int + scene.config.light_frac - 1);
    f.lu = in(-light, light - 1);
    f.lv = in(-light, light - 1);
    f.lit = in(0, 7) != 0;
    if (scene.unit.half_vector) {
      f.hu = in(-light, light - 1);
      f.hv = in(-light, light - 1);
    }
    f.x = static_cast<std::uint16_t>(in(0, 16383));
    f.y = static_cast<std::uint16_t>(in(0, 16383));
    return f;
  }

  int in(int low, int high) { return std::uniform_int_distribution(low, high)(rng_); }

 private:
  UnitScene add_draws(UnitScene out, int draws) {
    for (int d = 0; d < draws; ++d) add_draw(out);
    return out;
  }

  void build_effects(reference::UnitConfig& unit) {
    unit.extra_passes = in(0, reference::kExtraPasses);
    unit.extra_sets = in(0, unit.extra_passes);
    unit.half_vector = unit.extra_passes > 0 && in(0, 1) != 0;
    unit.stages = static_cast<unsigned>(in(0, 2) != 0 ? 7 : in(0, 7));
    unit.stages &= reference::effects::kStages;  // of a build without some
  }

  /// What a draw uses of what there is, and its table.
  void use_effects(UnitScene& out, reference::Draw& draw) {
    using reference::TextureFormat;
    reference::DrawEffects& e = draw.effects;
    const bool own =
        draw.format == TextureFormat::lrgb || draw.format == TextureFormat::palette_lrgb;
    if (draw.format != TextureFormat::none) e.sets = in(0, out.unit.extra_sets);
    if (own || e.sets > 0) e.passes = in(in(0, 1) * out.unit.extra_passes, out.unit.extra_passes);
    for (int k = 0; k < e.passes; ++k) {
      e.pass[static_cast<std::size_t>(k)] = {in(own ? 0 : 1, e.sets),
                                             out.unit.half_vector && in(0, 1) != 0};
    }
    for (int s = 0; s < e.sets; ++s) {
      fill(e.bias[static_cast<std::size_t>(s)], (1 << out.config.coef_bits) - 1);
      fill_shifts(out.config, e.shift[static_cast<std::size_t>(s)]);
    }
    e.stages = out.unit.stages & static_cast<unsigned>(in(0, 1) != 0 ? 7 : in(0, 7));
    e.argument = static_cast<std::uint32_t>(in(0, 3));
    reference::EffectTable table = reference::effect_table(in(0, 1) != 0 ? in(1, 20) : in(1, 255));
    if (in(0, 3) == 0) fill(table, 4095);  // entries need not rise
    out.state.tables.resize(out.state.draws.size());
    out.state.tables.push_back(table);
  }

  void fill_shifts(const reference::EvalConfig& built_for,
                   reference::Six<reference::Value>& shift) {
    for (auto& s : shift) s = in(built_for.shift_min, 15);
    if (built_for.shift_groups == 3) {
      shift[1] = shift[2] = shift[0];
      shift[4] = shift[3];
    }
  }

  template <class Level>
  void fill_sets(const UnitScene& out, const reference::Draw& draw, const std::vector<Level>& like,
                 DrawSource& source) {
    for (int s = 0; s < draw.effects.sets; ++s) {
      reference::StoredSet set;
      for (const Level& level : like) {
        reference::StoredTexture& made = set.emplace_back();
        made.width = level.width;
        made.height = level.height;
        made.coef.resize(static_cast<std::size_t>(level.width * level.height) * 6);
        fill(made.coef, (1 << out.config.coef_bits) - 1);
      }
      source.sets.push_back(std::move(set));
    }
  }

  template <class Range>
  void fill(Range& values, int most) {
    for (auto& v : values) v = static_cast<std::decay_t<decltype(v)>>(in(0, most));
  }

  reference::EvalConfig config() {
    if (in(0, 1) != 0) {
      return reference::kPresets[static_cast<std::size_t>(in(0, 2))].config;
    }
    return random_config(rng_);
  }

  int side() {
    constexpr std::array<int, 8> kOften{1, 1, 2, 12, 16, 20, 31, 64};
    return in(0, 1) != 0 ? in(1, 9) : kOften[static_cast<std::size_t>(in(0, 7))];
  }

  /// Now and then a side of 4,096.
  std::array<int, 2> sides() {
    std::array<int, 2> s{side(), side()};
    if (in(0, 15) == 0) s = {4096, in(1, 3)};
    if (in(0, 1) != 0) std::swap(s[0], s[1]);
    return s;
  }

  std::int32_t coordinate(int texels) {
    constexpr int kLimit = 1 << 28;
    switch (in(0, 4)) {
      case 0:  // on texels' edges and centres
        return in(-3 * texels, 3 * texels) * ((1 << 19) / texels) + in(-1, 1);
      case 1:  // about whole periods
        return in(-3, 3) * (1 << 20) + in(-2, 2);
      case 2:
        return in(-(1 << 21), 1 << 21);
      case 3:
        return in(0, 1) != 0 ? kLimit - 1 - in(0, 9) : -kLimit + in(0, 9);
      default:
        return in(-kLimit, kLimit - 1);
    }
  }

  void fill_palettes(UnitScene& out) {
    const int most = (1 << out.config.coef_bits) - 1;
    for (int p = 0; p < 4; ++p) {
      auto& palette = out.lrgb_palettes[static_cast<std::size_t>(p)];
      palette.resize(256 * 6);
      fill(palette, most);
      append_lrgb_palette(out.config, palette, p, out.state.palettes);
    }
    out.rgb_palette.resize(4096 * 18);
    fill(out.rgb_palette, most);
    set_rgb_palette(out.config, out.rgb_palette, out.state.palettes);
  }

  int levels_of(int width, int height) {
    int most = 1;
    while (std::max(width, height) >> most != 0) ++most;
    return in(0, 2) != 0 ? most : in(1, most);
  }

  template <class Make>
  auto make_levels(Make make) {
    const auto [width, height] = sides();
    std::vector<decltype(make(1, 1))> levels;
    const int count = levels_of(width, height);
    for (int l = 0; l < count; ++l) {
      levels.push_back(make(std::max(1, width >> l), std::max(1, height >> l)));
    }
    return levels;
  }

  /// Alpha is a byte that the maker of maps leaves at 255; the unit filters whatever is there.
  void add_alpha(const reference::TextureLevels& at, std::size_t planes, std::size_t plane,
                 DrawSource& source, std::vector<reference::Line>& memory) {
    for (std::size_t l = 0; l < source.map.size(); ++l) {
      const auto width = static_cast<std::size_t>(source.map[l].width);
      std::vector<std::uint8_t> alpha(width * static_cast<std::size_t>(source.map[l].height));
      fill(alpha, 255);
      for (std::size_t k = 0; k < alpha.size(); ++k) {
        const std::size_t x = k % width, y = k / width;
        const std::size_t tile = (y / 4) * ((width + 3) / 4) + x / 4;
        const std::size_t line = at.base[l] + tile * planes + plane;
        std::uint32_t& word = memory[line][y % 4 * 4 + x % 4];
        word = (word & 0xFFFFFFU) | static_cast<std::uint32_t>(alpha[k]) << 24;
      }
      source.map_alpha.push_back(alpha);
    }
  }

  void add_map(UnitScene& out, reference::Draw& draw, DrawSource& source) {
    const bool rgb = draw.format == reference::TextureFormat::rgb;
    source.map = make_levels([&](int width, int height) {
      reference::StoredTexture level{width, height, rgb, {}, {}, {}, {}};
      const auto texels = static_cast<std::size_t>(width * height);
      level.coef.resize(texels * (rgb ? 18 : 6));
      fill(level.coef, (1 << out.config.coef_bits) - 1);
      level.color.resize(rgb ? 0 : texels * 3);
      fill(level.color, 255);
      return level;
    });
    fill_sets(out, draw, source.map, source);
    draw.map = append_map(out.config, source.map, source.sets, out.state.memory);
    if (rgb) return;
    const auto colour = static_cast<std::size_t>(map_planes(draw.format, out.config) - 1);
    const auto planes = static_cast<std::size_t>(array_planes(draw, out.config));
    add_alpha(draw.map, planes, colour, source, out.state.memory);
  }

  void add_palette_map(UnitScene& out, reference::Draw& draw, DrawSource& source) {
    const bool rgb = draw.format == reference::TextureFormat::palette_rgb;
    source.palette_map = make_levels([&](int width, int height) {
      reference::StoredPaletteMap level{width, height, rgb, {}, {}};
      const auto texels = static_cast<std::size_t>(width * height);
      level.index.resize(texels);
      fill(level.index, rgb ? 4095 : 255);
      level.color.resize(rgb ? 0 : texels * 3);
      fill(level.color, 255);
      return level;
    });
    fill_sets(out, draw, source.palette_map, source);
    draw.map = append_palette_map(out.config, source.palette_map, source.sets, out.state.memory);
  }

  void add_color(UnitScene& out, reference::Draw& draw, DrawSource& source) {
    source.color = make_levels([&](int width, int height) {
      reference::StoredPicture level{width, height, {}};
      level.rgba.resize(static_cast<std::size_t>(width * height) * 4);
      fill(level.rgba, 255);
      return level;
    });
    draw.color_texture = append_picture(source.color, out.state.memory);
  }

  void add_draw(UnitScene& out) {
    using reference::TextureFormat;
    reference::Draw draw;
    DrawSource source;
    draw.format = static_cast<TextureFormat>(in(0, 4));
    draw.combine = draw.format == TextureFormat::none ? reference::Combine::replace
                                                      : static_cast<reference::Combine>(in(0, 5));
    draw.color = draw.combine != reference::Combine::none || in(0, 3) == 0;
    draw.bilinear = in(0, 3) != 0;
    draw.mip = static_cast<reference::Mip>(in(0, 2));
    draw.wrap_u = static_cast<reference::Wrap>(in(0, 2));
    draw.wrap_v = static_cast<reference::Wrap>(in(0, 2));
    draw.color_lod = in(0, 1) != 0 ? in(-512, 512) : in(-4096, 4095);
    draw.palette = in(0, 3);
    fill(draw.bias, (1 << out.config.coef_bits) - 1);
    fill_shifts(out.config, draw.shift);
    draw.ka = in(0, 511);
    draw.kd = in(0, 511);
    draw.ks = in(0, 511);
    if (with_effects_) use_effects(out, draw);
    if (draw.format == TextureFormat::lrgb || draw.format == TextureFormat::rgb) {
      add_map(out, draw, source);
    } else if (draw.format != TextureFormat::none) {
      add_palette_map(out, draw, source);
    }
    if (draw.color) add_color(out, draw, source);
    out.state.draws.push_back(draw);
    out.sources.push_back(std::move(source));
  }

  std::mt19937_64 rng_;
  bool with_effects_;
};

}  // namespace ptm::tests
