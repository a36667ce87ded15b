#include "golden/effects/given_light.h"

#include <algorithm>

#include "golden/files/figure_text.h"

namespace ptm::golden {

std::vector<EffectKey> coordinate_keys() {
  return {{.name = "coordinates",
           .kind = EffectKeyKind::pairs,
           .need = EffectKeyNeed::required,
           .low = -1,
           .high = 1}};
}

void give_light(const EffectSpec& spec, int frame, std::array<double, 2>& light, bool& lit) {
  const std::vector<double>& numbers = effect_numbers(spec, "coordinates");
  const std::size_t pair = std::min(static_cast<std::size_t>(frame), numbers.size() / 2 - 1);
  light = {numbers[2 * pair], numbers[2 * pair + 1]};
  lit = true;
}

void check_given_light(const EffectSpec& spec, EffectDraw& draw) {
  const LoadedTexture* map = draw.map();
  if (!map || map->polynomials != 3) {
    fail_effect(spec, draw, map ? "an LRGB map" : "no map",
                "an RGB map: its colours are what changes");
  }
  if (draw.draw.effects.size() > 1) {
    fail_effect(spec, draw, "another effect in the same object",
                "it alone: its map's parameters are no light");
  }
  const std::size_t pairs = effect_numbers(spec, "coordinates").size() / 2;
  if (pairs != 1 && pairs != draw.scene.lights.size()) {
    fail_effect(spec, draw, count_of(pairs, "pair") + " of coordinates",
                "one, or one for each [[light]]: " + std::to_string(draw.scene.lights.size()));
  }
}

}  // namespace ptm::golden
