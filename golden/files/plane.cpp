#include "golden/files/plane.h"

namespace ptm::golden {
namespace {

/// Where a plane's bytes lie in a map: the first byte and the distance between texels.
struct PlaneLayout {
  std::size_t first = 0;
  std::size_t stride = 0;
  bool in_color = false;
};

PlaneLayout layout_of(const PtmMap& map, std::size_t plane) {
  if (map.kind == MapKind::lrgb && plane >= 6) return {plane - 6, 3, true};
  return {plane, 6 * map.polynomials(), false};
}

/// Calls visit(file index, map index) for every texel: the file's rows run bottom-up.
template <class Visit>
void for_each_texel(const PtmMap& map, Visit visit) {
  const auto width = static_cast<std::size_t>(map.width);
  const auto height = static_cast<std::size_t>(map.height);
  for (std::size_t row = 0; row < height; ++row) {
    const std::size_t in_file = (height - 1 - row) * width;
    const std::size_t in_map = row * width;
    for (std::size_t x = 0; x < width; ++x) visit(in_file + x, in_map + x);
  }
}

}  // namespace

std::vector<Plane> split_planes(const PtmMap& map) {
  std::vector<Plane> planes;
  for (std::size_t p = 0; p < plane_count(map.kind); ++p) {
    const PlaneLayout layout = layout_of(map, p);
    const std::vector<std::uint8_t>& source = layout.in_color ? map.color : map.coef;
    Plane plane(map.texels());
    const std::span<std::uint8_t> bytes = plane.bytes();
    for_each_texel(map, [&](std::size_t in_file, std::size_t in_map) {
      bytes[in_file] = source[layout.first + layout.stride * in_map];
    });
    planes.push_back(std::move(plane));
  }
  return planes;
}

void join_planes(const std::vector<Plane>& planes, PtmMap& map) {
  map.coef.resize(map.texels() * 6 * map.polynomials());
  map.color.resize(map.texels() * map.color_bytes());
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const PlaneLayout layout = layout_of(map, p);
    std::vector<std::uint8_t>& target = layout.in_color ? map.color : map.coef;
    const std::span<const std::uint8_t> bytes = planes[p].bytes();
    for_each_texel(map, [&](std::size_t in_file, std::size_t in_map) {
      target[layout.first + layout.stride * in_map] = bytes[in_file];
    });
  }
}

}  // namespace ptm::golden
