#include <cmath>

#include "golden/effects/effect.h"
#include "golden/effects/reflectance.h"

/// Section 3.7: reflectance over the angle between the light and the surface's own normal, one
/// channel for a dielectric, three for a metal. Not normalised: 255 levels reflect everything.
namespace ptm::golden {
namespace {

/// Gold, n and k at 2.01, 2.26 and 2.75 eV (617, 549 and 451 nm): P. B. Johnson and R. W. Christy,
/// Optical Constants of the Noble Metals, Phys. Rev. B 6, 4370 (1972).
constexpr std::array<double, 3> kGoldN{0.21, 0.43, 1.38}, kGoldK{3.272, 2.455, 1.914};

void prepare(const EffectSpec& spec, EffectDraw& draw) {
  const auto& ior = effect_numbers(spec, "ior");
  std::vector<double> n = effect_numbers(spec, "n"), k = effect_numbers(spec, "k");
  if (!ior.empty() && (!n.empty() || !k.empty())) {
    fail_effect(spec, draw, "'ior' beside 'n' or 'k'",
                "ior of a dielectric, or n and k of a metal");
  }
  if (n.empty() != k.empty()) {
    fail_effect(spec, draw, n.empty() ? "'k' without 'n'" : "'n' without 'k'", "both");
  }
  if (!ior.empty()) {
    n = ior;
    k = {0};
  } else if (n.empty()) {
    n.assign(kGoldN.begin(), kGoldN.end());
    k.assign(kGoldK.begin(), kGoldK.end());
  }
  Modulator modulator;
  modulator.channels = static_cast<int>(n.size());
  modulator.uniform = true;
  modulator.value = [=](std::size_t, int channel, double lu, double lv) {
    const std::size_t c = static_cast<std::size_t>(channel);
    return reflectance(std::sqrt(std::max(0.0, 1 - lu * lu - lv * lv)), n[c], k[c]);
  };
  add_modulator(spec, draw, std::move(modulator));
}

EffectKey optional_key(const char* name, std::size_t count, double low, double high) {
  return {.name = name, .need = EffectKeyNeed::optional, .count = count, .low = low, .high = high};
}

}  // namespace

const Effect& fresnel_effect();
const Effect& fresnel_effect() {
  static const Effect effect{.id = "fresnel",
                             .name = "fresnel",
                             .keys = {optional_key("ior", 1, 1, 10), optional_key("n", 3, 0.01, 10),
                                      optional_key("k", 3, 0, 20)},
                             .prepare = prepare,
                             .texel = modulate_addend};
  return effect;
}

}  // namespace ptm::golden
