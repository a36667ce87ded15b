#include <algorithm>

#include "golden/effects/effect.h"

/// Eq. 15: the specular term times another map, of the same texels; 255 levels are 1. A map that is
/// the same under every light is a gloss map.
namespace ptm::golden {
namespace {

/// What a channel of the map radiates (Eq. 4), as a polynomial.
std::vector<double> radiated(const LoadedTexture& map, std::size_t channel) {
  std::vector<double> set(map.texels() * 6);
  for (std::size_t t = 0; t < map.texels(); ++t) {
    for (std::size_t k = 0; k < 6; ++k) {
      set[t * 6 + k] = map.polynomials == 3
                           ? map.coef[(t * 3 + channel) * 6 + k]
                           : map.color[t * 3 + channel] * map.coef[t * 6 + k] / 255;
    }
  }
  return set;
}

/// The other map's texels are sets of the draw's: sampled as its map is, and not palettised. What
/// its texture says otherwise would mean nothing.
void check_sampling(const EffectSpec& spec, const EffectDraw& draw, std::size_t gloss) {
  const TextureSpec& said = draw.scene.textures.at(gloss);
  const DrawSpec& is = draw.draw;
  const auto refuse_other = [&](const auto& value, const auto& of_draw, const char* key) {
    if (!value || *value == of_draw) return;
    fail_effect(spec, draw, "'" + said.name + "' with another " + key + " than the object's map",
                "the map's: both are sampled as one");
  };
  refuse_other(said.wrap_u, is.wrap_u, "wrap_u");
  refuse_other(said.wrap_v, is.wrap_v, "wrap_v");
  refuse_other(said.filter, is.filter, "filter");
  refuse_other(said.probes, is.probes, "probes");
  if (said.palette != 0 && static_cast<int>(gloss) != is.map) {
    fail_effect(spec, draw, "'" + said.name + "' with a palette",
                "a map without: what multiplies is stored texel by texel");
  }
}

void prepare(const EffectSpec& spec, EffectDraw& draw) {
  const auto index = static_cast<std::size_t>(effect_number(spec, "map"));
  const LoadedTexture& gloss = draw.textures.at(index);
  if (gloss.is_picture()) fail_effect(spec, draw, "'" + gloss.name + "', a plain picture", "a map");
  const LoadedTexture* map = draw.map();
  if (!map) fail_effect(spec, draw, "no map", "an object with 'texture'");
  if (gloss.width != map->width || gloss.height != map->height) {
    fail_effect(spec, draw,
                "'" + gloss.name + "' of " + std::to_string(gloss.width) + " x " +
                    std::to_string(gloss.height),
                "the size of '" + map->name + "', " + std::to_string(map->width) + " x " +
                    std::to_string(map->height));
  }
  check_sampling(spec, draw, index);
  Modulator modulator;
  for (std::size_t c = 0; c < 3; ++c) modulator.polynomials.push_back(radiated(gloss, c));
  auto& sets = modulator.polynomials;
  if (sets[0] == sets[1] && sets[0] == sets[2]) sets.resize(1);
  modulator.channels = static_cast<int>(sets.size());
  modulator.value = [all = sets](std::size_t texel, int channel, double lu, double lv) {
    Coefficients a{};
    std::copy_n(&all[static_cast<std::size_t>(channel)][texel * 6], 6, a.begin());
    return luminance(a, lu, lv) / 255;
  };
  add_modulator(spec, draw, std::move(modulator));
}

}  // namespace

const Effect& modulated_specular_effect();
const Effect& modulated_specular_effect() {
  static const Effect effect{
      .id = "modulated_specular",
      .name = "modulated-specular",
      .keys = {{.name = "map", .kind = EffectKeyKind::texture, .need = EffectKeyNeed::required}},
      .prepare = prepare,
      .texel = modulate_addend};
  return effect;
}

}  // namespace ptm::golden
