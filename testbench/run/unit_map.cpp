#include "testbench/run/unit_map.h"

#include <algorithm>
#include <numeric>

#include "golden/files/figure_text.h"
#include "model/quantize/gain.h"
#include "model/quantize/mip.h"
#include "testbench/run/map_parts.h"

namespace ptm::testbench {
namespace {

using reference::EvalConfig;
using reference::StoredTexture;

/// A texture's levels before they are stored.
struct RealLevels {
  std::vector<quantize::RealLevel> levels;
  std::vector<std::vector<std::uint8_t>> color;  ///< of each level; empty for three polynomials
};

RealLevels make_levels(const RealTexture& texture, std::vector<double> coef,
                       const std::vector<std::uint8_t>& color, int levels) {
  RealLevels made;
  const auto polynomials = static_cast<int>(texture.real.polynomials);
  made.levels.push_back({texture.width, texture.height, polynomials, std::move(coef)});
  if (levels > 1) {
    for (quantize::RealLevel& level : quantize::mip_levels(made.levels[0].view())) {
      if (static_cast<int>(made.levels.size()) < levels) made.levels.push_back(std::move(level));
    }
  }
  if (!color.empty()) {
    made.color =
        halve_bytes(color, texture.width, texture.height, 3, static_cast<int>(made.levels.size()));
  }
  return made;
}

StoredTexture stored_texture(const quantize::StoredMap& stored, std::vector<std::uint8_t> color) {
  StoredTexture texture;
  texture.width = stored.width;
  texture.height = stored.height;
  texture.rgb = stored.polynomials == 3;
  texture.coef = stored.coef;
  texture.color = std::move(color);
  std::copy(stored.bias.begin(), stored.bias.end(), texture.bias.begin());
  std::copy(stored.shift.begin(), stored.shift.end(), texture.shift.begin());
  return texture;
}

void take_grid(const quantize::Grid& grid, UnitMap& map) {
  std::copy(grid.bias.begin(), grid.bias.end(), map.bias.begin());
  std::copy(grid.shift.begin(), grid.shift.end(), map.shift.begin());
}

/// All levels on the grid of the first, which is stored already or is quantised.
UnitMap store_levels(const RealLevels& real, std::optional<quantize::StoredMap> top,
                     const EvalConfig& config) {
  const quantize::Gram gram = quantize::hemisphere_gram();
  if (!top) {
    top = quantize::quantize(real.levels[0].view(), config, quantize::Method::nearest_plane, gram);
  }
  const quantize::Grid grid{top->bias, top->shift};
  UnitMap map;
  take_grid(grid, map);
  map.rms_error = top->rms_error;
  map.saturated = std::accumulate(top->saturated.begin(), top->saturated.end(), std::uint64_t{0});
  for (std::size_t l = 0; l < real.levels.size(); ++l) {
    const quantize::StoredMap stored =
        l == 0 ? std::move(*top)
               : quantize::quantize_on_grid(real.levels[l].view(), grid, config,
                                            quantize::Method::nearest_plane, gram);
    map.levels.push_back(
        stored_texture(stored, real.color.empty() ? std::vector<std::uint8_t>{} : real.color[l]));
  }
  return map;
}

/// All levels' texels in a row, so that one palette serves them.
struct Flat {
  std::vector<double> coef;
  std::vector<std::uint8_t> color;
};
Flat flatten(const RealLevels& levels) {
  Flat flat;
  for (const quantize::RealLevel& level : levels.levels) {
    flat.coef.insert(flat.coef.end(), level.coef.begin(), level.coef.end());
  }
  for (const auto& color : levels.color) {
    flat.color.insert(flat.color.end(), color.begin(), color.end());
  }
  return flat;
}

}  // namespace

RealTexture real_texture(const golden::PtmMap& map) {
  RealTexture texture{map.width, map.height, real_polynomials(map), {}, map};
  if (map.kind == golden::MapKind::lrgb) texture.color = map.color;
  return texture;
}

int full_levels(int width, int height) {
  int levels = 1;
  for (int side = std::max(width, height); side > 1; side /= 2) ++levels;
  return levels;
}

UnitMap store_unit_map(const RealTexture& texture, int levels, const EvalConfig& config,
                       Strength strength) {
  std::vector<double> coef = texture.real.coef;
  std::vector<std::uint8_t> color = texture.color;
  const bool rgb = texture.real.polynomials == 3;
  quantize::Import import{std::nullopt, "its coefficients are real"};
  if (texture.file) import = import_map(*texture.file, config);
  if (!import.map && !rgb && strength == Strength::may_move) {
    quantize::balance_luminance(coef, color, hemisphere_lights(), config);
  }
  const std::string how = import.map ? "taken verbatim" : "quantised because " + import.why_not;
  UnitMap map = store_levels(make_levels(texture, std::move(coef), color, levels),
                             std::move(import.map), config);
  map.rgb = rgb;
  map.how = how;
  return map;
}

UnitMap store_unit_set(int width, int height, const std::vector<double>& coef, int levels,
                       const EvalConfig& config) {
  RealTexture texture;
  texture.width = width;
  texture.height = height;
  return store_levels(make_levels(texture, coef, {}, levels), std::nullopt, config);
}

UnitMap store_unit_palette(const RealTexture& texture, int levels, int entries,
                           const EvalConfig& config, Strength strength) {
  UnitMap map;
  map.rgb = texture.real.polynomials == 3;
  const RealLevels real = make_levels(texture, texture.real.coef, texture.color, levels);
  const Flat flat = flatten(real);
  const int polynomials = map.rgb ? 3 : 1;
  const auto texels = static_cast<int>(flat.coef.size()) / (6 * polynomials);
  PalettizedMap made = palettize({texels, 1, polynomials, flat.coef}, flat.color,
                                 {.entries = entries}, config, strength);
  map.rms_error = made.table.rms_error;
  take_grid({made.table.bias, made.table.shift}, map);
  map.palette = std::move(made.table.coef);
  auto index = made.palette.index.begin();
  auto color = made.color.begin();
  for (const quantize::RealLevel& level : real.levels) {
    const auto count = static_cast<std::ptrdiff_t>(level.width) * level.height;
    reference::StoredPaletteMap& stored = map.indexed.emplace_back();
    stored.width = level.width;
    stored.height = level.height;
    stored.rgb = map.rgb;
    stored.index.assign(index, index + count);
    index += count;
    if (map.rgb) continue;
    stored.color.assign(color, color + 3 * count);
    color += 3 * count;
  }
  map.how = "a palette of " + golden::count_of(made.palette.entries(), "entry");
  return map;
}

std::vector<reference::StoredPicture> picture_levels(const reference::StoredPicture& picture,
                                                     int levels) {
  std::vector<reference::StoredPicture> all;
  int width = picture.width, height = picture.height;
  for (auto& bytes : halve_bytes(picture.rgba, width, height, 4, levels)) {
    all.push_back({width, height, std::move(bytes)});
    width = quantize::half_side(width);
    height = quantize::half_side(height);
  }
  return all;
}

}  // namespace ptm::testbench
