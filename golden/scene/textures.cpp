#include "golden/scene/textures.h"

#include <algorithm>

#include "golden/bump/normal_map.h"
#include "golden/files/picture_file.h"
#include "golden/files/picture_header.h"
#include "golden/files/ptm_file.h"
#include "golden/files/ptm_header.h"
#include "golden/fit/fit_tile.h"
#include "golden/render/light_map.h"
#include "golden/scene/generate.h"

namespace ptm::golden {
namespace {

constexpr double kBumpStrength = 16;  ///< height of white in texels, as `ptmsim bump` has it
constexpr std::size_t kPhotoBudget = std::size_t{256} << 20;

void check_size(const TextureSpec& spec, int width, int height) {
  if (width <= kLargestTexture && height <= kLargestTexture) return;
  std::string advice = "make the picture smaller";
  if (spec.source == TextureSource::ptm) advice = crop_advice(spec.file, width, height);
  if (spec.source == TextureSource::capture) {
    advice = "`ptmsim fit " + spec.file.string() + " --region X,Y,W,H --out PART.ptm` fits a part";
  }
  throw InputError(spec.file.string(), "size of texture '" + spec.name + "'",
                   std::to_string(width) + " x " + std::to_string(height) + " texels",
                   "at most " + std::to_string(kLargestTexture) + " a side; " + advice);
}

/// Before anything is decoded.
void check_picture_size(const TextureSpec& spec) {
  const PictureHeader header = read_picture_header(spec.file);
  check_size(spec, header.width, header.height);
}

/// A channel of a LUM map: matrix row (r, y, b, 1) times (Cr, L, Cb, 1) is y L + a constant.
void add_lum_texel(const PtmMap& map, std::size_t texel, LoadedTexture& texture) {
  const Coefficients a = real_coefficients(map, texel);
  const double cr = map.color[texel * 2], cb = map.color[texel * 2 + 1];
  for (std::size_t c = 0; c < 3; ++c) {
    const double* row = &map.lum_matrix[c * 4];
    for (std::size_t k = 0; k < 6; ++k) {
      texture.coef.push_back(row[1] * a[k] + (k == 5 ? row[0] * cr + row[2] * cb + row[3] : 0));
    }
  }
}

LoadedTexture load_ptm(const TextureSpec& spec) {
  const PtmMap header = read_ptm_header(spec.file).map;
  check_size(spec, header.width, header.height);
  PtmFile file = read_ptm(spec.file);
  LoadedTexture texture;
  texture.notes = std::move(file.info.notes);
  const PtmMap& map = file.map;
  texture.width = map.width;
  texture.height = map.height;
  texture.polynomials = map.kind == MapKind::lrgb ? 1 : 3;
  for (std::size_t texel = 0; texel < map.texels(); ++texel) {
    if (map.kind == MapKind::lum) {
      add_lum_texel(map, texel, texture);
      continue;
    }
    for (std::size_t p = 0; p < map.polynomials(); ++p) {
      const Coefficients a = real_coefficients(map, texel, p);
      texture.coef.insert(texture.coef.end(), a.begin(), a.end());
    }
  }
  if (map.kind == MapKind::lum) return texture;
  if (map.kind == MapKind::lrgb) texture.color = map.color;
  texture.stored = std::move(file.map);
  return texture;
}

LoadedTexture load_capture(const TextureSpec& spec) {
  CaptureRequest request;
  request.source = spec.file;
  Capture capture = open_capture(request);
  LoadedTexture texture;
  texture.notes = capture.notes;
  texture.width = capture.region.width;
  texture.height = capture.region.height;
  check_size(spec, texture.width, texture.height);
  texture.polynomials = spec.kind == MapKind::rgb ? 3 : 1;
  const std::size_t stride = static_cast<std::size_t>(texture.polynomials) * 6;
  const std::size_t colors = spec.kind == MapKind::rgb ? 0 : 3;
  texture.coef.resize(texture.texels() * stride);
  texture.color.resize(texture.texels() * colors);
  const LightSolver solver = solve_lights(capture.directions);
  FitOptions options;
  options.kind = spec.kind;
  Capture* const captures[] = {&capture};
  PhotoBands bands(captures, kPhotoBudget);
  Band band;
  for (int b = 0; b < bands.bands(); ++b) {
    bands.read(b, band);
    const std::size_t before =
        static_cast<std::size_t>(band.first_row) * static_cast<std::size_t>(texture.width);
    for_each_tile(band.texels, [&](std::size_t, std::size_t first, std::size_t count) {
      fit_tile(band.tile(first, count, 0), solver, options,
               std::span(texture.coef).subspan((before + first) * stride, count * stride),
               std::span(texture.color).subspan((before + first) * colors, count * colors));
    });
  }
  return texture;
}

LoadedTexture load_bump(const TextureSpec& spec) {
  check_picture_size(spec);
  const ImageReal picture = read_picture(spec.file);
  NormalField field =
      spec.source == TextureSource::bump_heights
          ? normals_from_heights(picture, spec.strength.value_or(kBumpStrength))
          : read_normal_map(picture,
                            {.strength = spec.strength.value_or(1), .green_down = spec.green_down},
                            spec.file.string());
  LoadedTexture texture;
  texture.notes = std::move(field.notes);
  texture.width = field.width;
  texture.height = field.height;
  texture.coef = bump_coefficients(field, NormalTable(BumpDomain::hemisphere));
  texture.color.assign(texture.texels() * 3, 255);
  return texture;
}

LoadedTexture load_picture(const TextureSpec& spec) {
  check_picture_size(spec);
  const ImageReal picture = read_picture_with_alpha(spec.file);
  LoadedTexture texture;
  texture.polynomials = 0;
  texture.width = picture.width;
  texture.height = picture.height;
  texture.rgba = picture.samples;
  // A float picture may go beyond; the unit's colours are bytes.
  for (double& value : texture.rgba) value = std::clamp(value, 0.0, 255.0);
  return texture;
}

LoadedTexture load(const TextureSpec& spec) {
  switch (spec.source) {
    case TextureSource::ptm:
      return load_ptm(spec);
    case TextureSource::capture:
      return load_capture(spec);
    case TextureSource::bump_heights:
    case TextureSource::bump_normals:
      return load_bump(spec);
    case TextureSource::picture:
      return load_picture(spec);
    default:
      return generate_texture(spec);
  }
}

}  // namespace

std::string crop_advice(const std::filesystem::path& map_file, int width, int height) {
  return "`ptmsim convert " + map_file.string() + " PART.ptm --crop 0,0," +
         std::to_string(std::min(width, kLargestTexture)) + "," +
         std::to_string(std::min(height, kLargestTexture)) +
         "` cuts a part out (X,Y,W,H from the top left)";
}

LoadedTextures load_textures(const UnitScene& scene) {
  LoadedTextures textures;
  for (const TextureSpec& spec : scene.textures) {
    textures.push_back(load(spec));
    LoadedTexture& texture = textures.back();
    texture.name = spec.name;
    if (texture.polynomials == 1 && spec.palette > kMostLrgbEntries) {
      throw InputError(scene.file.string(), spec.place,
                       "a palette of " + std::to_string(spec.palette) + " entries",
                       "at most 256 for an LRGB map");
    }
  }
  return textures;
}

}  // namespace ptm::golden
