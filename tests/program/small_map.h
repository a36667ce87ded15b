#pragma once
#include <filesystem>

#include "golden/files/ptm_file.h"

namespace ptm::tests {

/// A map of made-up bytes that the hardware takes verbatim.
inline golden::PtmMap small_map(golden::MapKind kind, int width, int height) {
  golden::PtmMap map;
  map.kind = kind;
  map.width = width;
  map.height = height;
  map.scale = {2, 2, 1, 1, 2, 2};
  map.bias = {149, 151, 68, 77, 77, 0};
  map.coef.resize(map.texels() * map.polynomials() * 6);
  map.color.resize(map.texels() * map.color_bytes());
  for (std::size_t i = 0; i < map.coef.size(); ++i) {
    map.coef[i] = static_cast<std::uint8_t>((i * 97 + i / 6 * 13) % 256);
  }
  for (std::size_t i = 0; i < map.color.size(); ++i) {
    map.color[i] = static_cast<std::uint8_t>((i * 53 + 7) % 256);
  }
  return map;
}

}  // namespace ptm::tests
