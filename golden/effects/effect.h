#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "golden/effects/modulator.h"
#include "golden/render/light_map.h"
#include "golden/scene/textures.h"
#include "golden/scene/unit_scene.h"

/// Effects of sections 3.5 to 4.2 of Polynomial Texture Maps, in double precision, from their
/// equations. One file an effect; the rows stand in contract/effects.def, from which
/// effects() is generated. Twin: docs/spec/effects.md, which knows rounding and time; this side
/// knows neither. What each effect means and which form of an equation it takes:
/// docs/design/effects.md.
namespace ptm::golden {

/// An evaluator pass beyond the map's own, in the order in which passes give value[0], value[1] ...
struct EffectPass {
  int set = 0;        ///< 0: the map's polynomial; s: DrawExtras::sets[s - 1]
  bool half = false;  ///< lit with the half-vector instead of the light
};

/// What a draw's effects add to it, in real numbers: golden shades with it, and the hardware's
/// state is quantised from it. Pass 0 is the base of the power, passes 1.. the modulator's.
struct DrawExtras {
  std::vector<std::vector<double>> sets;  ///< each [height][width][6] of the map, levels
  std::vector<EffectPass> passes;
  std::uint32_t argument = 0;       ///< as docs/spec/effects.md
  double ks = 0;                    ///< weight of the specular term
  double exponent = 1;              ///< of the power
  std::array<double, 256> table{};  ///< what the power stage looks up, levels 0..255
  FitResidual residual;             ///< of the modulator's fit; 0 where none was needed
  std::vector<std::string> notes;   ///< said to the user
};

/// A draw while its effects prepare it, in the order of the rows.
struct EffectDraw {
  const UnitScene& scene;
  const LoadedTextures& textures;
  const DrawSpec& draw;
  std::optional<LoadedTexture> new_map, new_color;  ///< instead of the scene's
  DrawExtras extras;
  std::vector<Modulator> modulators;  ///< multiplied and fitted after all effects

  /// The map as it is by now; null if the draw has none.
  [[nodiscard]] const LoadedTexture* map() const;
  /// A copy to change. Requires a map.
  [[nodiscard]] LoadedTexture& change_map();
};

enum class EffectKeyKind : std::uint8_t {
  number,   ///< `count` numbers; a single one is no array
  integer,  ///< one
  texture,  ///< the name of a [[texture]]: its index
  word,     ///< one of `words`: its place among them
  pairs     ///< [a, b], or an array of those: one after the other
};
enum class EffectKeyNeed : std::uint8_t {
  standard,  ///< absent: EffectKey::standard, or a word's first
  required,
  optional  ///< absent: no numbers at all
};
/// One key of an [[object.effect]].
struct EffectKey {
  const char* name = "";
  EffectKeyKind kind = EffectKeyKind::number;
  EffectKeyNeed need = EffectKeyNeed::standard;
  std::size_t count = 1;
  double low = 0, high = 0;        ///< numbers: the range, ends included
  std::vector<double> standard{};  ///< default
  std::vector<const char*> words{};
};

/// One effect. Functions that it has no need of are null.
struct Effect {
  const char* id = "";
  const char* name = "";  ///< in scene files
  std::vector<EffectKey> keys{};
  bool half = false;          ///< its draws' samples bring the half-vector
  bool brings_color = false;  ///< makes the draw's colour picture; default combine is replace
  /// At load: derives maps, coefficient sets, passes. Throws InputError with the effect's place.
  void (*prepare)(const EffectSpec&, EffectDraw&) = nullptr;
  /// A sample's light, before anything is shaded or quantised; frame is the light's index. Called
  /// for the exact light and for the interpolated one.
  void (*light)(const EffectSpec&, int frame, std::array<double, 2>& light, bool& lit) = nullptr;
  /// One texel's addend from the values of its extra passes (levels, clamped to 0..255). Addends
  /// are filtered as the map is. Effects of a draw that share a function share its call.
  void (*texel)(const DrawExtras&, std::span<const double> values, Rgb& addend) = nullptr;
  /// The pixel, after combine_colors(), from the filtered addend; shared likewise.
  void (*pixel)(const DrawExtras&, const Rgb& addend, Rgb& color) = nullptr;
};

/// The effects that this build has, in the order of their rows.
[[nodiscard]] const std::vector<const Effect*>& effects();
/// Null if there is none of that name.
[[nodiscard]] const Effect* find_effect(const std::string& name);

/// A key's numbers; empty if it is optional and absent. `key` is one of the effect's (otherwise
/// std::logic_error).
[[nodiscard]] const std::vector<double>& effect_numbers(const EffectSpec& spec, const char* key);
[[nodiscard]] double effect_number(const EffectSpec& spec, const char* key);
/// InputError at the effect's place.
[[noreturn]] void fail_effect(const EffectSpec& spec, const EffectDraw& draw,
                              const std::string& found, const std::string& expected);

/// Notes how many texels of a draw's map have no maximum inside, unless all have one or it is
/// noted already.
void note_without_maximum(EffectDraw& draw, std::size_t count);

/// Lets every draw's effects prepare it: draws whose map or colour changed get a texture of their
/// own, appended to scene and textures. Returns the extras, one a draw; a draw without effects has
/// none. A scene without effects stays as it is. Throws InputError: an effect that its object's
/// textures or other effects do not allow.
[[nodiscard]] std::vector<DrawExtras> prepare_effects(UnitScene& scene, LoadedTextures& textures);

}  // namespace ptm::golden
