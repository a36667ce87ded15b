// A scene's textures in memory and its draws in registers.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "testbench/run/unit_job.h"
#include "testbench/run/unit_map.h"

namespace ptm::testbench {
namespace {

using golden::InputError;
using golden::UnitScene;
using reference::EvalConfig;
using reference::TextureFormat;

constexpr std::size_t kPalettesLrgb = 4;
constexpr int kEntriesLrgb = 256, kEntriesRgb = 4096;

RealTexture real_texture(const golden::LoadedTexture& texture) {
  RealTexture real;
  real.width = texture.width;
  real.height = texture.height;
  real.real.polynomials = static_cast<std::size_t>(texture.polynomials);
  real.real.coef = texture.coef;
  real.color = texture.color;
  real.file = texture.stored;
  return real;
}

reference::StoredPicture stored_picture(const golden::LoadedTexture& texture) {
  reference::StoredPicture picture{texture.width, texture.height, {}};
  picture.rgba.resize(texture.rgba.size());
  std::transform(texture.rgba.begin(), texture.rgba.end(), picture.rgba.begin(), [](double level) {
    return static_cast<std::uint8_t>(std::clamp(std::floor(level + 0.5), 0.0, 255.0));
  });
  return picture;
}

/// How a texture stands in the unit: what every draw that uses it copies.
struct Placed {
  TextureFormat format = TextureFormat::none;
  reference::TextureLevels levels;
  reference::Six<reference::Value> bias{}, shift{};
  int palette = 0;
};

/// A unit with all that effects may ask for: the plan sees to it that the scene's unit has it.
constexpr reference::UnitConfig kAnyUnit{.extra_sets = reference::kExtraSets,
                                         .extra_passes = reference::kExtraPasses,
                                         .half_vector = true,
                                         .stages = ~0U};

class StateBuilder {
 public:
  StateBuilder(const UnitScene& scene, const golden::LoadedTextures& textures,
               const std::vector<golden::DrawExtras>& extras, const EvalConfig& config,
               std::vector<std::string>& notes)
      : scene_(scene), textures_(textures), extras_(extras), config_(config), notes_(notes) {}

  reference::UnitState build() {
    for (std::size_t d = 0; d < scene_.draws.size(); ++d) {
      state_.draws.push_back(make_draw(scene_.draws[d], extras_[d]));
      if (!scene_.draws[d].effects.empty()) {
        state_.tables.resize(d);
        state_.tables.push_back(stored_table(extras_[d]));
      }
    }
    for (std::size_t d = 0; d < state_.draws.size(); ++d) check(d);
    return std::move(state_);
  }

 private:
  reference::Draw make_draw(const golden::DrawSpec& spec, const golden::DrawExtras& extras) {
    reference::Draw draw;
    draw.format = TextureFormat::none;
    draw.bilinear = spec.filter.bilinear;
    draw.mip = static_cast<reference::Mip>(spec.filter.mip);
    draw.wrap_u = static_cast<reference::Wrap>(spec.wrap_u);
    draw.wrap_v = static_cast<reference::Wrap>(spec.wrap_v);
    draw.combine = static_cast<reference::Combine>(spec.combine);
    draw.ka = weight(spec.ka);
    draw.kd = weight(spec.kd);
    draw.ks = weight(extras.ks);
    draw.effects = planned_effects(spec, extras);
    draw.color = spec.color >= 0;
    draw.color_lod =
        static_cast<reference::Value>(std::floor(golden::color_lod(spec, textures_) * 256 + 0.5));
    if (spec.map >= 0) {
      const Placed map =
          extras.sets.empty() ? place(spec.map) : place_map(spec.map, extras, draw.effects);
      draw.format = map.format;
      draw.map = map.levels;
      draw.bias = map.bias;
      draw.shift = map.shift;
      draw.palette = map.palette;
    }
    if (draw.color) draw.color_texture = place(spec.color).levels;
    return draw;
  }

  /// Q8.4
  static reference::EffectTable stored_table(const golden::DrawExtras& extras) {
    reference::EffectTable table{};
    std::transform(extras.table.begin(), extras.table.end(), table.begin(), [](double level) {
      return static_cast<std::uint16_t>(std::clamp(std::floor(level * 16 + 0.5), 0.0, 4095.0));
    });
    return table;
  }

  /// Q1.8
  static reference::Value weight(double k) {
    return std::clamp<reference::Value>(static_cast<reference::Value>(std::floor(k * 256 + 0.5)), 0,
                                        511);
  }

  [[nodiscard]] bool needs_levels(int texture) const {
    return std::any_of(scene_.draws.begin(), scene_.draws.end(), [&](const golden::DrawSpec& draw) {
      return (draw.map == texture || draw.color == texture) &&
             draw.filter.mip != golden::MipMode::none;
    });
  }

  const Placed& place(int index) {
    const auto found = placed_.find(index);
    if (found != placed_.end()) return found->second;
    const golden::LoadedTexture& texture = textures_[static_cast<std::size_t>(index)];
    Placed placed;
    if (texture.is_picture()) {
      placed.levels =
          append_picture(picture_levels(stored_picture(texture), levels_of(index)), state_.memory);
    } else {
      reference::DrawEffects none;
      placed = place_map(index, {}, none);
    }
    return placed_.emplace(index, placed).first->second;
  }

  [[nodiscard]] int levels_of(int index) const {
    const golden::LoadedTexture& texture = textures_[static_cast<std::size_t>(index)];
    return needs_levels(index) ? full_levels(texture.width, texture.height) : 1;
  }

  /// A map with the coefficient sets of a draw's effects in one array of lines; their bias and
  /// shift go into the draw.
  Placed place_map(int index, const golden::DrawExtras& extras, reference::DrawEffects& effects) {
    const golden::LoadedTexture& texture = textures_[static_cast<std::size_t>(index)];
    const int levels = levels_of(index);
    std::vector<reference::StoredSet> sets;
    for (std::size_t s = 0; s < extras.sets.size(); ++s) {
      UnitMap set = store_unit_set(texture.width, texture.height, extras.sets[s], levels, config_);
      effects.bias[s] = set.bias;
      effects.shift[s] = set.shift;
      sets.push_back(std::move(set.levels));
    }
    if (scene_.textures[static_cast<std::size_t>(index)].palette != 0) {
      return place_palette(index, texture, levels, sets);
    }
    const UnitMap map = store_unit_map(real_texture(texture), levels, config_);
    Placed placed = placed_map(map, map.rgb ? TextureFormat::rgb : TextureFormat::lrgb);
    placed.levels = append_map(config_, map.levels, sets, state_.memory);
    notes_.push_back("texture " + texture.name + ": " + map.how);
    return placed;
  }

  static Placed placed_map(const UnitMap& map, TextureFormat format) {
    Placed placed;
    placed.format = format;
    placed.bias = map.bias;
    placed.shift = map.shift;
    return placed;
  }

  Placed place_palette(int index, const golden::LoadedTexture& texture, int levels,
                       const std::vector<reference::StoredSet>& sets) {
    const golden::TextureSpec& spec = scene_.textures[static_cast<std::size_t>(index)];
    const bool rgb = texture.polynomials == 3;
    const int most = rgb ? kEntriesRgb : kEntriesLrgb;
    const int entries = spec.palette == golden::kFullPalette ? most : spec.palette;
    if (entries > most) {
      refuse(spec, std::to_string(entries) + " palette entries",
             rgb ? "at most 4096 for an RGB map" : "at most 256 for an LRGB map");
    }
    const UnitMap map = store_unit_palette(real_texture(texture), levels, entries, config_);
    Placed placed = placed_map(map, rgb ? TextureFormat::palette_rgb : TextureFormat::palette_lrgb);
    if (rgb) {
      if (!state_.palettes.rgb.empty()) refuse(spec, "a second RGB palette", "at most one");
      set_rgb_palette(config_, map.palette, state_.palettes);
    } else {
      if (palettes_ == kPalettesLrgb) refuse(spec, "a fifth LRGB palette", "at most four");
      placed.palette = static_cast<int>(palettes_++);
      append_lrgb_palette(config_, map.palette, placed.palette, state_.palettes);
    }
    placed.levels = append_palette_map(config_, map.indexed, sets, state_.memory);
    notes_.push_back("texture " + texture.name + ": " + map.how);
    return placed;
  }

  [[noreturn]] void refuse(const golden::TextureSpec& spec, const std::string& found,
                           const std::string& expected) const {
    throw InputError(scene_.file.string(), spec.place, found, expected);
  }

  void check(std::size_t d) const {
    const unsigned errors = check_draw(state_.draws[d], state_.memory.size(), kAnyUnit);
    if (errors == 0) return;
    throw InputError(scene_.file.string(), "draw " + std::to_string(d),
                     "a descriptor with error bits " + std::to_string(errors),
                     "a legal one (docs/spec/unit.md)");
  }

  const UnitScene& scene_;
  const golden::LoadedTextures& textures_;
  const std::vector<golden::DrawExtras>& extras_;
  const EvalConfig& config_;
  std::vector<std::string>& notes_;
  reference::UnitState state_;
  std::map<int, Placed> placed_;
  std::size_t palettes_ = 0;
};

}  // namespace

reference::UnitState make_unit_state(const UnitScene& scene, const golden::LoadedTextures& textures,
                                     const std::vector<golden::DrawExtras>& extras,
                                     const EvalConfig& config, std::vector<std::string>& notes) {
  return StateBuilder(scene, textures, extras, config, notes).build();
}

}  // namespace ptm::testbench
