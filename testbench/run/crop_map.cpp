#include "testbench/run/crop_map.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "golden/files/input_error.h"

namespace ptm::testbench {
namespace {

/// The rectangle's bytes of [height][width][texel_bytes].
std::vector<std::uint8_t> crop_bytes(const std::vector<std::uint8_t>& bytes, int width,
                                     std::size_t texel_bytes, const golden::Region& part) {
  const std::size_t row = static_cast<std::size_t>(width) * texel_bytes;
  const std::size_t count = static_cast<std::size_t>(part.width) * texel_bytes;
  std::vector<std::uint8_t> out;
  out.reserve(count * static_cast<std::size_t>(part.height));
  for (int y = part.y; y < part.y + part.height; ++y) {
    const auto from =
        bytes.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * row +
                                                    static_cast<std::size_t>(part.x) * texel_bytes);
    out.insert(out.end(), from, from + static_cast<std::ptrdiff_t>(count));
  }
  return out;
}

}  // namespace

golden::PtmMap crop_map(const golden::PtmMap& map, const golden::Region& part,
                        const std::string& file) {
  // Differences, since sums might go beyond int.
  const bool within = part.x >= 0 && part.y >= 0 && part.width >= 1 && part.height >= 1 &&
                      part.x < map.width && part.y < map.height &&
                      part.width <= map.width - part.x && part.height <= map.height - part.y;
  if (!within) {
    throw golden::InputError(
        file, "the part to cut out",
        std::to_string(part.width) + " x " + std::to_string(part.height) + " texels at " +
            std::to_string(part.x) + ", " + std::to_string(part.y),
        "a part of the map's " + std::to_string(map.width) + " x " + std::to_string(map.height));
  }
  golden::PtmMap out;
  out.kind = map.kind;
  out.width = part.width;
  out.height = part.height;
  out.scale = map.scale;
  out.bias = map.bias;
  out.lum_matrix = map.lum_matrix;
  out.coef = crop_bytes(map.coef, map.width, 6 * map.polynomials(), part);
  out.color = crop_bytes(map.color, map.width, map.color_bytes(), part);
  return out;
}

}  // namespace ptm::testbench
