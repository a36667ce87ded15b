#include "golden/effects/effect.h"

/// Section 4.1, method 3: the constraint lu^2 + lv^2 <= 1 (Eq. 20) need not hold when a map is
/// evaluated. The light's two coordinates times a gain; what is lit stays lit.
namespace ptm::golden {
namespace {

void prepare(const EffectSpec& spec, EffectDraw& draw) {
  if (!draw.map()) fail_effect(spec, draw, "no map", "an object with 'texture'");
}

void scale_light(const EffectSpec& spec, int, std::array<double, 2>& light, bool&) {
  const double gain = effect_number(spec, "gain");
  for (double& part : light) part *= gain;
}

}  // namespace

const Effect& light_extrapolation_effect();
const Effect& light_extrapolation_effect() {
  static const Effect effect{
      .id = "light_extrapolation",
      .name = "light-extrapolation",
      .keys = {{.name = "gain", .low = 0.001, .high = 1000, .standard = {1.5}}},
      .prepare = prepare,
      .light = scale_light};
  return effect;
}

}  // namespace ptm::golden
