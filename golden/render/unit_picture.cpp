#include "golden/render/unit_picture.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "golden/render/area_average.h"
#include "golden/render/texture_filter.h"

namespace ptm::golden {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

template <class Shade>
ImageReal picture_of(const UnitScene& scene, std::span<const SurfaceSample> samples,
                     LightFrom light, const Shade& shade) {
  ImageReal image(scene.size[0], scene.size[1], 3);
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    image.samples[i] = scene.background[i % 3];
  }
  constexpr std::size_t chunk = 256;
  tbb::parallel_for(std::size_t{0}, (samples.size() + chunk - 1) / chunk, [&](std::size_t n) {
    const std::size_t end = std::min((n + 1) * chunk, samples.size());
    for (std::size_t i = n * chunk; i < end; ++i) {
      const SurfaceSample& sample = samples[i];
      const bool exact = light == LightFrom::pixel;
      const Rgb color = shade(sample, exact ? sample.light : sample.light_vertex,
                              exact ? sample.half : sample.half_vertex);
      std::copy(color.begin(), color.end(), &image.at(sample.x, sample.y));
    }
  });
  return image;
}

/// Whether an effect of the draw does more than change what is loaded or asked.
bool changes_pixels(const DrawSpec& draw) {
  return std::any_of(draw.effects.begin(), draw.effects.end(), [](const EffectSpec& spec) {
    const Effect* effect = find_effect(spec.effect);
    return effect && effect->pixel;
  });
}

}  // namespace

Rgb combine_colors(const DrawSpec& draw, const Rgba& lit, const Rgba& color) {
  Rgb out{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double p = lit[c], t = color[c];
    switch (draw.combine) {
      case CombineMode::none:
        out[c] = p;
        break;
      case CombineMode::modulate:
        out[c] = p * t / 255;
        break;
      case CombineMode::decal:
        out[c] = (t * color[3] + p * (255 - color[3])) / 255;
        break;
      case CombineMode::blend:
        out[c] = std::min(255.0, draw.kd * p + draw.ka * t);
        break;
      case CombineMode::add:
        out[c] = std::min(255.0, p + t);
        break;
      case CombineMode::replace:
        out[c] = t;
        break;
    }
  }
  return out;
}

UnitRenderer::UnitRenderer(const UnitScene& scene, const LoadedTextures& textures,
                           std::span<const DrawExtras> extras)
    : scene_(&scene) {
  for (std::size_t t = 0; t < textures.size(); ++t) {
    const bool levels =
        std::any_of(scene.draws.begin(), scene.draws.end(), [&](const DrawSpec& draw) {
          const int n = static_cast<int>(t);
          return draw.filter.mip != MipMode::none && (draw.map == n || draw.color == n);
        });
    mips_.emplace_back(textures[t], levels);
  }
  for (const DrawSpec& draw : scene.draws) color_lods_.push_back(color_lod(draw, textures));
  for (std::size_t d = 0; d < extras.size(); ++d) {
    addends_.emplace_back();
    const DrawSpec& draw = scene.draws[d];
    if (!changes_pixels(draw)) continue;
    addends_.back().emplace(draw.map >= 0 ? &textures[index(draw.map)] : nullptr, draw, extras[d],
                            draw.filter.mip != MipMode::none);
  }
}

template <class Ask>
Rgb UnitRenderer::combined(const SurfaceSample& sample, const std::array<double, 2>& half,
                           const Ask& ask) const {
  const DrawSpec& draw = scene_->draws[index(sample.draw)];
  Rgba lit{0, 0, 0, 255}, color{};
  if (draw.map >= 0 && sample.lit) lit = ask(mips_[index(draw.map)], draw, 0);
  if (draw.color >= 0) {
    color = ask(mips_[index(draw.color)], draw, color_lods_[index(sample.draw)]);
  }
  const Rgb plain = combine_colors(draw, lit, color);
  if (addends_.empty() || !addends_[index(sample.draw)]) return plain;
  const AddendTexture& addend = *addends_[index(sample.draw)];
  const bool adds = addend.passes() > 0 && sample.lit;
  return addend.pixel(adds ? ask(AddendView{&addend, half}, draw, 0) : Rgba{}, plain);
}

Rgb UnitRenderer::shade(const SurfaceSample& sample, const std::array<double, 2>& light,
                        const std::array<double, 2>& half) const {
  return combined(sample, half, [&](const auto& texture, const DrawSpec& draw, double more) {
    return filter_texture(texture, {.u = sample.u,
                                    .v = sample.v,
                                    .axis_u = sample.axis_u,
                                    .axis_v = sample.axis_v,
                                    .probes = 1 << sample.probes_log2,
                                    .lod = sample.lod + more,
                                    .filter = draw.filter,
                                    .wrap_u = draw.wrap_u,
                                    .wrap_v = draw.wrap_v,
                                    .light = light});
  });
}

Rgb UnitRenderer::area_average(const SurfaceSample& sample, const std::array<double, 2>& light,
                               const std::array<double, 2>& half) const {
  return combined(sample, half, [&](const auto& texture, const DrawSpec& draw, double) {
    const PixelFootprint footprint{.u = sample.u,
                                   .v = sample.v,
                                   .dudx = sample.dudx,
                                   .dvdx = sample.dvdx,
                                   .dudy = sample.dudy,
                                   .dvdy = sample.dvdy};
    return golden::area_average(texture, footprint, draw.wrap_u, draw.wrap_v, light);
  });
}

ImageReal render_samples(const UnitScene& scene, const UnitRenderer& renderer,
                         std::span<const SurfaceSample> samples, LightFrom light) {
  return picture_of(scene, samples, light,
                    [&](const SurfaceSample& s, const auto& l, const auto& h) {
                      return renderer.shade(s, l, h);
                    });
}

ImageReal exact_area_average(const UnitScene& scene, const UnitRenderer& renderer,
                             std::span<const SurfaceSample> samples, LightFrom light) {
  return picture_of(scene, samples, light,
                    [&](const SurfaceSample& s, const auto& l, const auto& h) {
                      return renderer.area_average(s, l, h);
                    });
}

}  // namespace ptm::golden
