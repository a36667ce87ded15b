#include <algorithm>

#include "golden/effects/curvature_gain.h"
#include "golden/effects/effect.h"

/// Section 4.1, method 2, Eq. 19. An RGB map's three polynomials are bent about the one peak of
/// their luma, so that the luma's peak stays.
namespace ptm::golden {
namespace {

void prepare(const EffectSpec& spec, EffectDraw& draw) {
  if (!draw.map()) fail_effect(spec, draw, "no map", "an object with 'texture'");
  const double gain = effect_number(spec, "gain");
  LoadedTexture& map = draw.change_map();
  map.name += ", gain";
  std::size_t without = 0;
  const auto polynomials = static_cast<std::size_t>(map.polynomials);
  for (std::size_t t = 0; t < map.texels(); ++t) {
    const Peak peak = brightest_light(luma_polynomial(map, t));
    without += peak.kind != PeakKind::inside;
    for (std::size_t p = 0; p < polynomials; ++p) {
      double* coef = &map.coef[(t * polynomials + p) * 6];
      Coefficients a{};
      std::copy_n(coef, 6, a.begin());
      const Coefficients bent = with_curvature_gain(a, peak, gain);
      std::copy(bent.begin(), bent.end(), coef);
    }
  }
  const std::string note = without_maximum_note(map, without);
  if (!note.empty()) draw.extras.notes.push_back(note);
}

}  // namespace

const Effect& diffuse_gain_effect();
const Effect& diffuse_gain_effect() {
  static const Effect effect{.id = "diffuse_gain",
                             .name = "diffuse-gain",
                             .keys = {{.name = "gain", .low = 0, .high = 1000, .standard = {2}}},
                             .prepare = prepare};
  return effect;
}

}  // namespace ptm::golden
