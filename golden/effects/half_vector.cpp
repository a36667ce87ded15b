#include "golden/effects/specular_term.h"

/// Section 3.5: the same map, evaluated a second time with the halfway vector, gives N . H.
/// Only of use where the polynomial is a dot product with a normal, as of bump maps; an RGB map has
/// three and none of them is.
namespace ptm::golden {
namespace {

void prepare(const EffectSpec& spec, EffectDraw& draw) {
  const LoadedTexture* map = draw.map();
  if (!map || map->polynomials != 1) {
    fail_effect(spec, draw, map ? "an RGB map" : "no map",
                "an LRGB map, whose luminance is N . L; any map goes with specular-enhancement");
  }
  add_specular_term(spec, draw, 0);
}

}  // namespace

const Effect& half_vector_effect();
const Effect& half_vector_effect() {
  static const Effect effect{.id = "half_vector",
                             .name = "half-vector",
                             .keys = specular_keys(),
                             .half = true,
                             .prepare = prepare,
                             .texel = specular_addend,
                             .pixel = add_to_pixel};
  return effect;
}

}  // namespace ptm::golden
