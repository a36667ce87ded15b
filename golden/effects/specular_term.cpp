#include "golden/effects/specular_term.h"

#include <algorithm>
#include <cmath>

namespace ptm::golden {

std::vector<EffectKey> specular_keys() {
  constexpr double largest_weight = 511.0 / 256;  // Q1.8
  return {{.name = "ks", .low = 0, .high = largest_weight, .standard = {0.5}},
          {.name = "exponent",
           .kind = EffectKeyKind::integer,
           .low = 1,
           .high = 255,
           .standard = {20}}};
}

void add_specular_term(const EffectSpec& spec, EffectDraw& draw, int set) {
  DrawExtras& extras = draw.extras;
  if (!extras.passes.empty()) {
    fail_effect(spec, draw, "a second specular term",
                "one of half-vector and specular-enhancement: the unit has one power");
  }
  extras.passes.push_back({.set = set, .half = true});
  extras.ks = effect_number(spec, "ks");
  extras.exponent = effect_number(spec, "exponent");
  for (std::size_t i = 0; i < extras.table.size(); ++i) {
    extras.table[i] = 255 * std::pow(static_cast<double>(i) / 255, extras.exponent);
  }
}

void specular_addend(const DrawExtras& extras, std::span<const double> values, Rgb& addend) {
  addend.fill(extras.ks * 255 * std::pow(values[0] / 255, extras.exponent));
}

void add_to_pixel(const DrawExtras&, const Rgb& addend, Rgb& color) {
  for (std::size_t c = 0; c < 3; ++c) color[c] = std::min(255.0, color[c] + addend[c]);
}

}  // namespace ptm::golden
