#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "golden/render/light_map.h"
#include "golden/scene/textures.h"
#include "golden/scene/unit_scene.h"

/// Effects of sections 3.5 to 4.2 of Polynomial Texture Maps, in double precision, from their
/// equations. One file an effect; the rows stand in testbench/plan/effects.def, from which
/// effects() is generated. Twin: docs/spec/effects.md, which knows rounding and time; this side
/// knows neither.
namespace ptm::golden {

/// An evaluator pass beyond the map's own, in the order in which passes give value[0], value[1] ...
struct EffectPass {
  int set = 0;        ///< 0: the map's polynomial; s: DrawExtras::sets[s - 1]
  bool half = false;  ///< lit with the half-vector instead of the light
};

/// What a draw's effects add to it, in real numbers: golden shades with it, and the hardware's
/// state is quantised from it.
struct DrawExtras {
  std::vector<std::vector<double>> sets;  ///< each [height][width][6] of the map, levels
  std::vector<EffectPass> passes;
  std::uint32_t argument = 0;       ///< as docs/spec/effects.md
  double ks = 0;                    ///< weight of the specular term
  double exponent = 1;              ///< of the power
  std::array<double, 256> table{};  ///< what the power stage looks up, levels 0..255
};

/// A draw while its effects prepare it, in the order of the rows. `map` and `color` are copies of
/// the scene's textures that the effect may change; empty if the draw has none.
struct EffectDraw {
  std::string file;  ///< the scene's, for errors
  std::optional<LoadedTexture> map, color;
  bool map_changed = false, color_changed = false;
  DrawExtras extras;
  const LoadedTextures* textures = nullptr;  ///< the scene's, which a key may name
};

/// Reads one table of [[object.effect]]: what an effect's keys say.
enum class EffectKeyKind : std::uint8_t { number, integer, texture, word };
struct EffectKey {
  const char* name;
  EffectKeyKind kind = EffectKeyKind::number;
  std::size_t count = 1;           ///< numbers: how many
  double low = 0, high = 0;        ///< numbers: the range, ends included
  std::vector<double> standard;    ///< default; empty: the key is required
  std::vector<const char*> words;  ///< of a word: the choices, the first is the default
};

/// One effect. Functions that it has no need of are null.
struct Effect {
  const char* id = "";
  const char* name = "";  ///< in scene files
  std::vector<EffectKey> keys;
  /// At load: derives maps, coefficient sets, passes. Throws InputError with the effect's place.
  void (*prepare)(const EffectSpec&, EffectDraw&) = nullptr;
  /// A sample's light, before anything is shaded or quantised.
  void (*light)(const EffectSpec&, std::array<double, 2>& light, bool& lit) = nullptr;
  /// One texel's addend from the values of its extra passes (levels, clamped to 0..255); in the
  /// order of the rows. Addends are filtered as the map is.
  void (*texel)(const EffectSpec&, const DrawExtras&, std::span<const double> values,
                Rgb& addend) = nullptr;
  /// The pixel, after combine_colors(), from the filtered addend.
  void (*pixel)(const EffectSpec&, const DrawExtras&, const Rgb& addend, Rgb& color) = nullptr;
};

/// The effects that this build has, in the order of their rows.
[[nodiscard]] const std::vector<const Effect*>& effects();
/// Null if there is none of that name.
[[nodiscard]] const Effect* find_effect(const std::string& name);

/// Lets every draw's effects prepare it: draws whose map or colour changed get a texture of their
/// own, appended to scene and textures. Returns the extras, one a draw; a draw without effects has
/// none.
[[nodiscard]] std::vector<DrawExtras> prepare_effects(UnitScene& scene, LoadedTextures& textures);

}  // namespace ptm::golden
