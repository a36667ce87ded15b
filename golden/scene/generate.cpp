#include "golden/scene/generate.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "golden/bump/bump_map.h"
#include "golden/scene/effect_patterns.h"
#include "golden/scene/image_stack.h"
#include "golden/scene/noise.h"
#include "golden/scene/slab.h"
#include "golden/scene/tablet.h"

namespace ptm::golden {
namespace {

/// Where in its cell of n x n cells a texel lies: -1..1 each, y down.
struct InCell {
  int column = 0, row = 0;
  double x = 0, y = 0;
};
InCell in_cell(double u, double v, int cells) {
  const double x = u * cells, y = v * cells;
  const double column = std::floor(x), row = std::floor(y);
  return {static_cast<int>(column), static_cast<int>(row), 2 * (x - column) - 1, 2 * (y - row) - 1};
}

Stuff checker(double u, double v) {
  const InCell cell = in_cell(u, v, 8);
  Stuff stuff;
  const double slope = 0.5;
  if (std::abs(cell.x) > std::abs(cell.y)) {
    stuff.normal = Vec3(std::copysign(slope, cell.x), 0, 1);
  } else if (cell.y != 0) {
    stuff.normal = Vec3(0, -std::copysign(slope, cell.y), 1);
  }
  const bool light = (cell.column + cell.row) % 2 == 0;
  stuff.color = light ? std::array{0.95, 0.85, 0.6} : std::array{0.2, 0.3, 0.55};
  stuff.alpha = light ? 1 : 0;
  return stuff;
}

Stuff studs(double u, double v) {
  const InCell cell = in_cell(u, v, 6);
  const double radius = 0.8, r = std::hypot(cell.x, cell.y) / radius;
  Stuff stuff;
  stuff.color = {0.15 + 0.85 * u, 0.15 + 0.85 * v, 0.3};
  stuff.alpha = std::max(0.0, 1 - r);
  if (r >= 1) return stuff;
  const double steep = 0.9;  // the rim does not stand upright
  const double x = steep * cell.x / radius, y = -steep * cell.y / radius;
  stuff.normal = Vec3(x, y, std::sqrt(1 - x * x - y * y));
  stuff.color = {0.9, 0.88, 0.8};
  return stuff;
}

Stuff noise(std::uint64_t seed, int x, int y) {
  const auto at = [&](int z) { return hash_noise(seed, x, y, z); };
  const double w = 0.2 + 0.8 * at(0), angle = 2 * std::numbers::pi * at(1);
  const double r = std::sqrt(1 - w * w);
  return {Vec3(r * std::cos(angle), r * std::sin(angle), w), {at(2), at(3), at(4)}, at(5)};
}

Stuff slab(std::uint64_t seed, double u, double v, double step_u, double step_v) {
  const double x = 2 * u - 1, y = 1 - 2 * v;
  const auto height = [&](double px, double py) { return slab_at(seed, px, py).height; };
  const SlabPoint here = slab_at(seed, x, y);
  const double dx = (height(x + step_u, y) - height(x - step_u, y)) / (2 * step_u);
  const double dy = (height(x, y + step_v) - height(x, y - step_v)) / (2 * step_v);
  return {Vec3(-dx, -dy, 1), here.albedo, std::clamp(here.gloss, 0.0, 1.0)};
}

Stuff stuff_at(const TextureSpec& spec, int x, int y) {
  const double u = (x + 0.5) / spec.size[0], v = (y + 0.5) / spec.size[1];
  if (spec.pattern == "checker") return checker(u, v);
  if (spec.pattern == "studs") return studs(u, v);
  if (spec.pattern == "noise") return noise(spec.seed, x, y);
  if (spec.pattern == "disc") return disc_at(spec.seed, u, v);
  if (spec.pattern == "metal") return metal_at(spec.seed, u, v);
  if (spec.pattern == "gloss") return gloss_at(spec.seed, u, v);
  // A texel's own width, in half widths of the slab; coarse maps do not skip over its carvings.
  if (spec.pattern == "relief") {
    return slab(spec.seed, u, v, std::min(0.01, 1.0 / spec.size[0]),
                std::min(0.01, 1.0 / spec.size[1]));
  }
  return {Vec3(0, 0, 1), {u, v, 128.0 / 255}, 1 - u};
}

std::uint8_t level(double value) {
  return static_cast<std::uint8_t>(std::floor(255 * std::clamp(value, 0.0, 1.0) + 0.5));
}

/// One polynomial, white-lit, of each normal, in levels.
void add_polynomials(const Vec3& normal, const NormalTable& table, double strength,
                     std::vector<double>& coef) {
  const Vec3 n = normal.normalized();
  for (const double a : table.find({n.x(), n.y(), n.z()})) coef.push_back(255 * strength * a);
}

void add_steady(double strength, std::vector<double>& coef) {
  coef.insert(coef.end(), {0, 0, 0, 0, 0, 255 * strength});
}

void add_map_texel(const Stuff& stuff, const NormalTable& table, LoadedTexture& texture) {
  if (texture.polynomials == 1) {
    if (stuff.steady) {
      add_steady(1, texture.coef);
    } else {
      add_polynomials(stuff.normal, table, 1, texture.coef);
    }
    for (const double c : stuff.color) texture.color.push_back(level(c));
    return;
  }
  if (stuff.steady) {
    for (const double c : stuff.color) add_steady(c, texture.coef);
    return;
  }
  const Vec3 n = stuff.normal.normalized();
  for (int c = 0; c < 3; ++c) {
    const Vec3 leaning = n + Vec3(0.15 * (c - 1), 0, 0);
    add_polynomials(leaning, table, stuff.color[static_cast<std::size_t>(c)], texture.coef);
  }
}

template <class Value>
void append(std::vector<Value>& to, const std::vector<Value>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

std::span<const std::string_view> pattern_kinds(std::string_view pattern) {
  static constexpr std::array<std::string_view, 3> any{"lrgb", "rgb", "picture"};
  if (pattern == "tablet") return std::span(any).first(1);
  if (pattern == "focus" || pattern == "tide") return std::span(any).subspan(1, 1);
  return any;
}

LoadedTexture generate_texture(const TextureSpec& spec) {
  if (spec.pattern == "tablet") return make_tablet(spec);
  if (spec.pattern == "focus") return make_focus_stack(spec);
  if (spec.pattern == "tide") return make_tide(spec);
  LoadedTexture texture;
  texture.name = spec.name;
  texture.width = spec.size[0];
  texture.height = spec.size[1];
  texture.polynomials = spec.plain ? 0 : spec.kind == MapKind::rgb ? 3 : 1;
  const NormalTable table(BumpDomain::hemisphere);
  std::vector<LoadedTexture> rows(static_cast<std::size_t>(texture.height));
  tbb::parallel_for(0, texture.height, [&](int y) {
    LoadedTexture& row = rows[static_cast<std::size_t>(y)];
    row.polynomials = texture.polynomials;
    for (int x = 0; x < texture.width; ++x) {
      const Stuff stuff = stuff_at(spec, x, y);
      if (!spec.plain) {
        add_map_texel(stuff, table, row);
        continue;
      }
      for (const double c : stuff.color) row.rgba.push_back(level(c));
      row.rgba.push_back(level(stuff.alpha));
    }
  });
  for (const LoadedTexture& row : rows) {
    append(texture.coef, row.coef);
    append(texture.color, row.color);
    append(texture.rgba, row.rgba);
  }
  return texture;
}

}  // namespace ptm::golden
