#include <cmath>
#include <numbers>

#include "golden/effects/effect.h"

/// Section 3.7: "the magnitude of the light vector projected onto the normal plane" of a texel's
/// direction of anisotropy t, which lies in the surface:
///
///     |L - (L.t) t| = sqrt(1 - (L.t)^2),   L.t = lu tu + lv tv
///
/// Its square is a polynomial of Eq. 5; itself, and any other power, is fitted.
namespace ptm::golden {
namespace {

using Direction = std::array<double, 2>;

/// The groove at a texel, u right and v up: concentric circles about the map's middle, or lines.
Direction groove(const LoadedTexture& map, bool disc, double angle, std::size_t texel) {
  if (!disc) return {std::cos(angle), std::sin(angle)};
  const auto width = static_cast<std::size_t>(map.width);
  const double x = (static_cast<double>(texel % width) + 0.5) / map.width - 0.5;
  const double y = 0.5 - (static_cast<double>(texel / width) + 0.5) / map.height;
  const double r = std::hypot(x, y);
  if (r == 0) return {1, 0};
  // `angle` turns the grooves off their circles: 90 degrees are spokes.
  const double c = std::cos(angle), s = std::sin(angle);
  return {(-y * c - x * s) / r, (x * c - y * s) / r};
}

void prepare(const EffectSpec& spec, EffectDraw& draw) {
  const bool disc = effect_number(spec, "pattern") == 0;
  const double angle = effect_number(spec, "angle") * std::numbers::pi / 180;
  const double power = effect_number(spec, "power");
  const LoadedTexture* map = draw.map();
  if (!map) fail_effect(spec, draw, "no map", "an object with 'texture'");
  std::vector<Direction> grooves(map->texels());
  for (std::size_t t = 0; t < grooves.size(); ++t) grooves[t] = groove(*map, disc, angle, t);
  Modulator modulator;
  modulator.uniform = !disc;
  if (power == 2) {
    std::vector<double>& set = modulator.polynomials.emplace_back();
    for (const auto& [tu, tv] : grooves) {
      set.insert(set.end(), {-255 * tu * tu, -255 * tv * tv, -510 * tu * tv, 0, 0, 255});
    }
  }
  modulator.value = [power, grooves = std::move(grooves)](std::size_t texel, int, double lu,
                                                          double lv) {
    const double along = lu * grooves[texel][0] + lv * grooves[texel][1];
    return std::pow(std::max(0.0, 1 - along * along), power / 2);
  };
  add_modulator(spec, draw, std::move(modulator));
}

}  // namespace

const Effect& anisotropic_effect();
const Effect& anisotropic_effect() {
  static const Effect effect{
      .id = "anisotropic",
      .name = "anisotropic",
      .keys =
          {{.name = "pattern", .kind = EffectKeyKind::word, .words = {"disc", "linear"}},
           {.name = "angle", .low = -360, .high = 360, .standard = {0}},
           {.name = "power", .kind = EffectKeyKind::integer, .low = 1, .high = 8, .standard = {1}}},
      .prepare = prepare,
      .texel = modulate_addend};
  return effect;
}

}  // namespace ptm::golden
