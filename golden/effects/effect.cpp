#include "golden/effects/effect.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace ptm::golden {

// A function an effect rather than an object: none is built before it is asked for.
#define PTM_GOLDEN_EFFECT(id) const Effect& id##_effect();
#include "effects/golden_effects.inc"
#undef PTM_GOLDEN_EFFECT

const std::vector<const Effect*>& effects() {
  static const std::vector<const Effect*> all{
#define PTM_GOLDEN_EFFECT(id) &id##_effect(),
#include "effects/golden_effects.inc"
#undef PTM_GOLDEN_EFFECT
  };
  return all;
}

const Effect* find_effect(const std::string& name) {
  for (const Effect* effect : effects()) {
    if (name == effect->name) return effect;
  }
  return nullptr;
}

const std::vector<double>& effect_numbers(const EffectSpec& spec, const char* key) {
  const Effect* effect = find_effect(spec.effect);
  if (!effect) throw std::logic_error("no effect '" + spec.effect + "'");
  for (std::size_t k = 0; k < effect->keys.size(); ++k) {
    if (std::strcmp(effect->keys[k].name, key) == 0) return spec.numbers.at(k);
  }
  throw std::logic_error("no key '" + std::string(key) + "' of " + spec.effect);
}

double effect_number(const EffectSpec& spec, const char* key) {
  return effect_numbers(spec, key).at(0);
}

void fail_effect(const EffectSpec& spec, const EffectDraw& draw, const std::string& found,
                 const std::string& expected) {
  throw InputError(draw.scene.file.string(), spec.place, spec.effect + ": " + found, expected);
}

const LoadedTexture* EffectDraw::map() const {
  if (new_map) return &*new_map;
  return draw.map < 0 ? nullptr : &textures[static_cast<std::size_t>(draw.map)];
}

LoadedTexture& EffectDraw::change_map() {
  if (!new_map) {
    new_map = textures.at(static_cast<std::size_t>(draw.map));
    new_map->stored.reset();  // its bytes are no longer what the map says
  }
  return *new_map;
}

namespace {

/// A texture of the draw's own, sampled as `like` is. Returns its index.
int add_texture(UnitScene& scene, LoadedTextures& textures, LoadedTexture texture, int like) {
  TextureSpec spec = scene.textures.at(static_cast<std::size_t>(like));
  spec.name = texture.name;
  if (texture.is_picture()) {
    spec.plain = true;
    spec.palette = 0;
  }
  scene.textures.push_back(std::move(spec));
  textures.push_back(std::move(texture));
  return static_cast<int>(textures.size()) - 1;
}

}  // namespace

std::vector<DrawExtras> prepare_effects(UnitScene& scene, LoadedTextures& textures) {
  std::vector<DrawExtras> all(scene.draws.size());
  for (std::size_t d = 0; d < scene.draws.size(); ++d) {
    if (scene.draws[d].effects.empty()) continue;
    EffectDraw work{.scene = scene,
                    .textures = textures,
                    .draw = scene.draws[d],
                    .new_map = {},
                    .new_color = {},
                    .extras = {},
                    .modulators = {}};
    for (const EffectSpec& spec : work.draw.effects) {
      const Effect* effect = find_effect(spec.effect);
      if (effect && effect->prepare) effect->prepare(spec, work);
    }
    finish_modulators(work);
    all[d] = std::move(work.extras);
    DrawSpec& draw = scene.draws[d];
    const int like = draw.main_texture();
    // What is replaced by a picture of its own need not be fetched.
    const bool unseen = work.new_color && draw.combine == CombineMode::replace;
    if (work.new_map) draw.map = add_texture(scene, textures, std::move(*work.new_map), like);
    if (work.new_color) draw.color = add_texture(scene, textures, std::move(*work.new_color), like);
    if (unseen && all[d].passes.empty()) draw.map = -1;
  }
  return all;
}

}  // namespace ptm::golden
