#include "testbench/run/edge_samples.h"

#include <algorithm>
#include <cmath>

#include "model/reference/fragment.h"

namespace ptm::testbench {
namespace {

/// In the level that `lod` lies in and the next.
bool on_edge_of(double u, double v, double lod, const reference::TextureLevels& texture,
                const reference::Draw& draw) {
  const int last = draw.mip == reference::Mip::none ? 0 : texture.levels - 1;
  const int first = static_cast<int>(std::clamp(std::floor(lod), 0.0, static_cast<double>(last)));
  for (int level = first; level <= std::min(first + 1, last); ++level) {
    if (on_texel_edge(u, texture.level_width(level), draw.wrap_u)) return true;
    if (on_texel_edge(v, texture.level_height(level), draw.wrap_v)) return true;
  }
  return false;
}

}  // namespace

bool on_texel_edge(double coordinate, int size, reference::Wrap wrap) {
  const double code = std::ldexp(coordinate, reference::kCoordinateFrac);
  if (code == std::floor(code)) return false;  // not rounded
  const double texels = coordinate * size, edge = std::round(texels);
  if (std::abs(texels - edge) > std::ldexp(size, -reference::kCoordinateFrac - 1)) return false;
  switch (wrap) {
    case reference::Wrap::clamp:
      return edge >= 1 && edge <= size - 1;
    case reference::Wrap::mirror:
      return std::remainder(edge, size) != 0;
    case reference::Wrap::repeat:
      break;
  }
  return size > 1;
}

bool on_texel_edge(double u, double v, double lod, const reference::Draw& draw) {
  if (draw.bilinear) return false;
  const double color_lod = lod + std::ldexp(static_cast<double>(draw.color_lod), -8);
  const bool map =
      draw.format != reference::TextureFormat::none && on_edge_of(u, v, lod, draw.map, draw);
  return map || (draw.color && on_edge_of(u, v, color_lod, draw.color_texture, draw));
}

}  // namespace ptm::testbench
