#include "testbench/run/edge_samples.h"

#include <cmath>

#include "model/reference/fragment.h"

namespace ptm::testbench {
namespace {

bool on_edge_of(double u, double v, int width, int height, const reference::Draw& draw) {
  return on_texel_edge(u, width, draw.wrap_u) || on_texel_edge(v, height, draw.wrap_v);
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

bool on_texel_edge(double u, double v, const reference::Draw& draw) {
  if (draw.bilinear) return false;
  const bool map = draw.format != reference::TextureFormat::none &&
                   on_edge_of(u, v, draw.map.width, draw.map.height, draw);
  return map || (draw.color &&
                 on_edge_of(u, v, draw.color_texture.width, draw.color_texture.height, draw));
}

}  // namespace ptm::testbench
