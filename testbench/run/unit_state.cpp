// A scene's textures in memory and its draws in registers.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "golden/files/figure_text.h"
#include "testbench/plan/golden_codes.h"
#include "testbench/run/hardware_map.h"
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
    draw.mip = mip_of(spec.filter.mip);
    draw.wrap_u = wrap_of(spec.wrap_u);
    draw.wrap_v = wrap_of(spec.wrap_v);
    draw.combine = combine_of(spec.combine);
    draw.ka = weight(spec.ka);
    draw.kd = weight(spec.kd);
    draw.ks = weight(extras.ks);
    draw.effects = planned_effects(spec, extras);
    draw.color = spec.color >= 0;
    draw.color_lod =
        static_cast<reference::Value>(std::floor(golden::color_lod(spec, textures_) * 256 + 0.5));
    if (spec.map >= 0) {
      const Strength strength = strength_of(extras);
      const Placed map = extras.sets.empty() ? place_map(spec.map, strength)
                                             : place_sets(spec.map, strength, extras, draw.effects);
      draw.format = map.format;
      draw.map = map.levels;
      draw.bias = map.bias;
      draw.shift = map.shift;
      draw.palette = map.palette;
    }
    if (draw.color) draw.color_texture = place_picture(spec.color);
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

  [[nodiscard]] const golden::LoadedTexture& texture(int index) const {
    return textures_[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] int levels_of(int index) const {
    return needs_levels(index) ? full_levels(texture(index).width, texture(index).height) : 1;
  }

  /// A pass that evaluates the map's own polynomial wants it as it is.
  static Strength strength_of(const golden::DrawExtras& extras) {
    const bool own = std::any_of(extras.passes.begin(), extras.passes.end(),
                                 [](const golden::EffectPass& pass) { return pass.set == 0; });
    return own ? Strength::stays : Strength::may_move;
  }

  reference::TextureLevels place_picture(int index) {
    const auto found = pictures_.find(index);
    if (found != pictures_.end()) return found->second;
    const auto levels = append_picture(
        picture_levels(stored_picture(texture(index)), levels_of(index)), state_.memory);
    return pictures_.emplace(index, levels).first->second;
  }

  Placed place_map(int index, Strength strength) {
    const auto found = placed_.find({index, strength});
    if (found != placed_.end()) return found->second;
    return placed_.emplace(std::pair(index, strength), append(index, strength, {})).first->second;
  }

  /// A map with the coefficient sets of a draw's effects in one array of lines; their bias and
  /// shift go into the draw.
  Placed place_sets(int index, Strength strength, const golden::DrawExtras& extras,
                    reference::DrawEffects& effects) {
    std::vector<reference::StoredSet> sets;
    for (std::size_t s = 0; s < extras.sets.size(); ++s) {
      UnitMap set = store_unit_set(texture(index).width, texture(index).height, extras.sets[s],
                                   levels_of(index), config_);
      effects.bias[s] = set.bias;
      effects.shift[s] = set.shift;
      note_saturation(texture(index).name + ", set " + std::to_string(s + 1), set);
      sets.push_back(std::move(set.levels));
    }
    return append(index, strength, sets);
  }

  /// The lines of a map that is stored, and quantised once however many draws have it.
  Placed append(int index, Strength strength, std::span<const reference::StoredSet> sets) {
    const Held& held = hold(index, strength);
    Placed placed = held.placed;
    placed.levels = held.map.indexed.empty()
                        ? append_map(config_, held.map.levels, sets, state_.memory)
                        : append_palette_map(config_, held.map.indexed, sets, state_.memory);
    return placed;
  }

  /// A map as it is stored, before it has lines.
  struct Held {
    UnitMap map;
    Placed placed;
  };

  const Held& hold(int index, Strength strength) {
    const auto found = held_.find({index, strength});
    if (found != held_.end()) return found->second;
    Held held;
    if (scene_.textures[static_cast<std::size_t>(index)].palette != 0) {
      held = hold_palette(index, strength);
    } else {
      held.map = store_unit_map(real_texture(texture(index)), levels_of(index), config_, strength);
      held.placed = placed_map(held.map, reference::map_format(held.map.rgb));
    }
    // Not refused: an effect may ask for such coefficients, and what is above white stays white.
    const std::string beyond = beyond_hardware(held.map.rms_error);
    if (!beyond.empty()) notes_.push_back("texture " + texture(index).name + ": " + beyond);
    notes_.push_back("texture " + texture(index).name + ": " + held.map.how);
    note_saturation(texture(index).name, held.map);
    return held_.emplace(std::pair(index, strength), std::move(held)).first->second;
  }

  /// Outliers saturate as a matter of course; a thousandth of all coefficients is a loss.
  void note_saturation(const std::string& name, const UnitMap& map) {
    if (map.levels.empty()) return;
    const std::size_t all = map.levels[0].coef.size();
    if (map.saturated * 1000 < all) return;
    notes_.push_back("texture " + name + ": " + std::to_string(map.saturated) + " of " +
                     std::to_string(all) +
                     " coefficients are beyond what the hardware holds and were limited");
  }

  static Placed placed_map(const UnitMap& map, TextureFormat format) {
    Placed placed;
    placed.format = format;
    placed.bias = map.bias;
    placed.shift = map.shift;
    return placed;
  }

  Held hold_palette(int index, Strength strength) {
    const golden::TextureSpec& spec = scene_.textures[static_cast<std::size_t>(index)];
    const bool rgb = texture(index).polynomials == 3;
    const int most = rgb ? kEntriesRgb : kEntriesLrgb;
    const int entries = spec.palette == golden::kFullPalette ? most : spec.palette;
    if (entries > most) {
      refuse(spec, golden::count_of(entries, "palette entry"),
             rgb ? "at most 4096 for an RGB map" : "at most 256 for an LRGB map");
    }
    Held held;
    held.map = store_unit_palette(real_texture(texture(index)), levels_of(index), entries, config_,
                                  strength);
    held.placed = placed_map(held.map, reference::map_format(rgb, true));
    if (rgb) {
      if (!state_.palettes.rgb.empty()) refuse(spec, "a second RGB palette", "at most one");
      set_rgb_palette(config_, held.map.palette, state_.palettes);
    } else {
      if (palettes_ == kPalettesLrgb) refuse(spec, "a fifth LRGB palette", "at most four");
      held.placed.palette = static_cast<int>(palettes_++);
      append_lrgb_palette(config_, held.map.palette, held.placed.palette, state_.palettes);
    }
    return held;
  }

  [[noreturn]] void refuse(const golden::TextureSpec& spec, const std::string& found,
                           const std::string& expected) const {
    throw InputError(scene_.file.string(), spec.place, found, expected);
  }

  void check(std::size_t d) const {
    const unsigned errors = check_draw(state_.draws[d], state_.memory.size(), kAnyUnit, config_);
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
  std::map<std::pair<int, Strength>, Placed> placed_;  ///< without sets
  std::map<std::pair<int, Strength>, Held> held_;
  std::map<int, reference::TextureLevels> pictures_;
  std::size_t palettes_ = 0;
};

}  // namespace

reference::UnitState make_unit_state(const UnitScene& scene, const golden::LoadedTextures& textures,
                                     const std::vector<golden::DrawExtras>& extras,
                                     const EvalConfig& config, std::vector<std::string>& notes) {
  return StateBuilder(scene, textures, extras, config, notes).build();
}

}  // namespace ptm::testbench
