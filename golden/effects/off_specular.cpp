#include "golden/effects/effect.h"

/// Section 3.7: a modulator "whose magnitude increases as the incident angle approaches grazing".
/// The simplest such is a polynomial of Eq. 5 itself, so it is stored without error:
///
///     facing + (grazing - facing) sin^2 = facing + (grazing - facing) (lu^2 + lv^2)
namespace ptm::golden {
namespace {

void prepare(const EffectSpec& spec, EffectDraw& draw) {
  const double facing = effect_number(spec, "facing");
  const double rise = effect_number(spec, "grazing") - facing;
  Modulator modulator;
  modulator.uniform = true;
  modulator.value = [=](std::size_t, int, double lu, double lv) {
    return facing + rise * (lu * lu + lv * lv);
  };
  const LoadedTexture* map = draw.map();
  std::vector<double>& set = modulator.polynomials.emplace_back();
  for (std::size_t t = 0; map && t < map->texels(); ++t) {
    set.insert(set.end(), {255 * rise, 255 * rise, 0, 0, 0, 255 * facing});
  }
  add_modulator(spec, draw, std::move(modulator));
}

}  // namespace

const Effect& off_specular_effect();
const Effect& off_specular_effect() {
  static const Effect effect{.id = "off_specular",
                             .name = "off-specular",
                             .keys = {{.name = "facing", .low = 0, .high = 1, .standard = {0.2}},
                                      {.name = "grazing", .low = 0, .high = 1, .standard = {1}}},
                             .prepare = prepare,
                             .texel = modulate_addend};
  return effect;
}

}  // namespace ptm::golden
