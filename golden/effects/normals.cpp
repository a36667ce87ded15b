#include "golden/effects/effect.h"
#include "golden/effects/map_normals.h"

/// The map's normals (Eq. 16-18) as a picture: 255 (n + 1) / 2 in red, green and blue, alpha 255.
namespace ptm::golden {
namespace {

void prepare(const EffectSpec& spec, EffectDraw& draw) {
  const LoadedTexture* map = draw.map();
  if (!map) fail_effect(spec, draw, "no map", "an object with 'texture'");
  const MapNormals normals = map_normals(*map);
  LoadedTexture picture;
  picture.name = map->name + ", normals";
  picture.width = map->width;
  picture.height = map->height;
  picture.polynomials = 0;
  for (const auto& n : normals.field.normals) {
    for (const double part : n) picture.rgba.push_back(255 * (part + 1) / 2);
    picture.rgba.push_back(255);
  }
  draw.new_color = std::move(picture);
  const std::string note = without_maximum_note(*map, normals.without_maximum);
  if (!note.empty()) draw.extras.notes.push_back(note);
}

}  // namespace

const Effect& normals_effect();
const Effect& normals_effect() {
  static const Effect effect{
      .id = "normals", .name = "normals", .brings_color = true, .prepare = prepare};
  return effect;
}

}  // namespace ptm::golden
