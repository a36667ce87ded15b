#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "golden/files/image.h"
#include "golden/render/addend_texture.h"
#include "golden/render/light_map.h"
#include "golden/render/mip_levels.h"
#include "golden/scene/surface_samples.h"

/// Shades a unit scene in double precision: what docs/spec/unit.md does, without its rounding and
/// in the right order, lights first and filters then.
namespace ptm::golden {

/// P (lit) and C with its alpha, combined:
///
///     none P, modulate P C / 255, decal (C Ca + P (255 - Ca)) / 255,
///     blend min(255, kd P + ka C), add min(255, P + C), replace C
[[nodiscard]] Rgb combine_colors(const DrawSpec& draw, const Rgba& lit, const Rgba& color);

/// A scene's textures with their mip levels, ready to be sampled.
class UnitRenderer {
 public:
  /// Builds the levels that the scene's filters ask for. Scene, textures and extras must stay
  /// where they are. `extras` are prepare_effects()'s, one a draw; none if no draw has effects.
  UnitRenderer(const UnitScene& scene, const LoadedTextures& textures,
               std::span<const DrawExtras> extras = {});

  /// The colour of one sample, levels, not rounded.
  ///
  ///     P = 1/N sum over probes of the filtered map, lit texel by texel and clamped to [0, 255];
  ///         0 if !sample.lit.   C: the colour texture, filtered alike, lod + color_lod.
  ///     Then combine_colors(). If the draw has extra passes and the sample is lit, its effects
  ///     then get their addend, filtered as the map is.
  /// `light` is sample.light or sample.light_vertex, as the caller wants it; `half` likewise.
  [[nodiscard]] Rgb shade(const SurfaceSample& sample, const std::array<double, 2>& light,
                          const std::array<double, 2>& half) const;
  [[nodiscard]] Rgb shade(const SurfaceSample& sample, const std::array<double, 2>& light) const {
    return shade(sample, light, sample.half);
  }

  /// The yardstick: instead of the filter, texels of level 0 averaged over the parallelogram that
  /// the pixel covers (area_average.h), map, colour and addend each; then combined as above.
  [[nodiscard]] Rgb area_average(const SurfaceSample& sample, const std::array<double, 2>& light,
                                 const std::array<double, 2>& half) const;

 private:
  template <class Ask>
  [[nodiscard]] Rgb combined(const SurfaceSample& sample, const std::array<double, 2>& half,
                             const Ask& ask) const;

  const UnitScene* scene_;
  std::vector<MipTexture> mips_;                       ///< one a texture
  std::vector<double> color_lods_;                     ///< one a draw
  std::vector<std::optional<AddendTexture>> addends_;  ///< one a draw; empty without extras
};

enum class LightFrom : std::uint8_t { pixel, vertex };

/// A picture of samples, [height][width][3], background elsewhere. Runs on all cores.
[[nodiscard]] ImageReal render_samples(const UnitScene& scene, const UnitRenderer& renderer,
                                       std::span<const SurfaceSample> samples,
                                       LightFrom light = LightFrom::pixel);
/// The same by area_average().
[[nodiscard]] ImageReal exact_area_average(const UnitScene& scene, const UnitRenderer& renderer,
                                           std::span<const SurfaceSample> samples,
                                           LightFrom light = LightFrom::pixel);

}  // namespace ptm::golden
