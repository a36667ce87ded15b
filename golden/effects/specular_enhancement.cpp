#include "golden/effects/map_normals.h"
#include "golden/effects/specular_term.h"
#include "golden/effects/touching_polynomial.h"

/// Section 4.1, method 1: every texel's normal out of its own polynomial (Eq. 16-18), and of that
/// normal a polynomial of N . H, to be evaluated with the half-vector.
namespace ptm::golden {
namespace {

void prepare(const EffectSpec& spec, EffectDraw& draw) {
  const LoadedTexture* map = draw.map();
  if (!map) fail_effect(spec, draw, "no map", "an object with 'texture'");
  const MapNormals normals = map_normals(*map);
  std::vector<double>& set = draw.extras.sets.emplace_back();
  set.reserve(map->texels() * 6);
  for (const auto& normal : normals.field.normals) {
    for (const double a : touching_polynomial(normal)) set.push_back(255 * a);
  }
  add_specular_term(spec, draw, static_cast<int>(draw.extras.sets.size()));
  const std::string note = without_maximum_note(*map, normals.without_maximum);
  if (!note.empty()) draw.extras.notes.push_back(note);
}

}  // namespace

const Effect& specular_enhancement_effect();
const Effect& specular_enhancement_effect() {
  static const Effect effect{.id = "specular_enhancement",
                             .name = "specular-enhancement",
                             .keys = specular_keys(),
                             .half = true,
                             .prepare = prepare,
                             .texel = specular_addend,
                             .pixel = add_to_pixel};
  return effect;
}

}  // namespace ptm::golden
