#include "golden/effects/effect.h"
#include "golden/scene/scene_parts.h"

namespace ptm::golden {
namespace {

constexpr std::array<std::pair<std::string_view, CombineMode>, 6> kCombines{
    {{"none", CombineMode::none},
     {"modulate", CombineMode::modulate},
     {"decal", CombineMode::decal},
     {"blend", CombineMode::blend},
     {"add", CombineMode::add},
     {"replace", CombineMode::replace}}};

constexpr double kLargestWeight = 511.0 / 256;  ///< Q1.8

/// The index of the texture that a key names, -1 without the key.
int find_texture(const TableReader& table, std::string_view key,
                 const std::vector<TextureSpec>& textures, bool picture) {
  if (!table.has(key)) return -1;
  std::string name;
  table.read(key, name);
  for (std::size_t i = 0; i < textures.size(); ++i) {
    if (textures[i].name != name) continue;
    if (textures[i].is_picture() != picture) {
      table.fail(key, "'" + name + "', a " + (picture ? "map" : "plain picture"),
                 picture ? "a plain picture" : "a map; a plain picture goes with 'color'");
    }
    return static_cast<int>(i);
  }
  table.fail(key, "'" + name + "'", "the name of a [[texture]]");
}

/// The map's value where it says one, else the colour's, else the default. Both must not differ.
template <class Value>
Value shared(const TableReader& table, const std::optional<Value>& map,
             const std::optional<Value>& color, Value otherwise, const std::string& what) {
  if (map && color && *map != *color) {
    table.fail("color", "another " + what + " than the map's",
               "the map's: a draw's two textures share it");
  }
  return map ? *map : color ? *color : otherwise;
}

/// Whether an effect makes the draw's colour picture. Both from a scene and from an effect it
/// cannot come.
bool color_from_effect(const TableReader& table, const DrawSpec& draw) {
  for (const EffectSpec& spec : draw.effects) {
    if (!find_effect(spec.effect)->brings_color) continue;
    if (draw.color >= 0) {
      table.fail("color", "a colour texture beside " + spec.effect, "one of them: both are it");
    }
    return true;
  }
  return false;
}

void read_combine(const TableReader& table, DrawSpec& draw) {
  const bool made = color_from_effect(table, draw), colored = draw.color >= 0 || made;
  draw.combine = !colored               ? CombineMode::none
                 : made || draw.map < 0 ? CombineMode::replace
                                        : CombineMode::modulate;
  table.choose<CombineMode>("combine", draw.combine, kCombines);
  if (!colored && draw.combine != CombineMode::none) {
    table.fail("combine", "a combine without a colour texture", "'color', or combine = \"none\"");
  }
  if (colored && draw.combine == CombineMode::none) {
    table.fail("combine", "'none' with a colour texture", "a combine that uses it");
  }
  if (draw.map < 0 && draw.combine != CombineMode::replace) {
    table.fail("combine", "a combine without a map", "'texture', or combine = \"replace\"");
  }
  for (const std::string_view key : {"ka", "kd"}) {
    if (table.has(key) && draw.combine != CombineMode::blend) {
      table.fail(key, "a weight without blend", "combine = \"blend\"");
    }
  }
  table.read("ka", draw.ka, 0, kLargestWeight);
  table.read("kd", draw.kd, 0, kLargestWeight);
}

}  // namespace

DrawSpec read_draw(const TableReader& table, const std::vector<TextureSpec>& textures) {
  DrawSpec draw;
  draw.map = find_texture(table, "texture", textures, false);
  draw.color = find_texture(table, "color", textures, true);
  if (draw.map < 0 && draw.color < 0) {
    table.fail("", "neither 'texture' nor 'color'", "at least one of them");
  }
  draw.effects = read_effects(table, textures);
  read_combine(table, draw);
  const TextureSpec none;
  const TextureSpec& map = draw.map < 0 ? none : textures[static_cast<std::size_t>(draw.map)];
  const TextureSpec& color = draw.color < 0 ? none : textures[static_cast<std::size_t>(draw.color)];
  draw.wrap_u = shared(table, map.wrap_u, color.wrap_u, draw.wrap_u, "wrap_u");
  draw.wrap_v = shared(table, map.wrap_v, color.wrap_v, draw.wrap_v, "wrap_v");
  draw.filter = shared(table, map.filter, color.filter, draw.filter, "filter");
  draw.probes = shared(table, map.probes, color.probes, draw.probes, "number of probes");
  return draw;
}

}  // namespace ptm::golden
