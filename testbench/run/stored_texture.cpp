#include "testbench/run/stored_texture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ptm::testbench {

StoredTexture store_texture(const golden::PtmMap& map, const reference::EvalConfig& config,
                            quantize::Method method) {
  const int polynomials = static_cast<int>(map.polynomials());
  quantize::Import import = quantize::import_verbatim({.width = map.width,
                                                       .height = map.height,
                                                       .polynomials = polynomials,
                                                       .coef = map.coef,
                                                       .scale = map.scale,
                                                       .bias = map.bias},
                                                      config);
  if (import.map) return {std::move(*import.map), {}};
  std::vector<double> real(map.coef.size());
  for (std::size_t k = 0; k < real.size(); ++k) {
    const std::size_t i = k % quantize::kSix;
    real[k] = (static_cast<double>(map.coef[k]) - map.bias[i]) * map.scale[i];
  }
  return {quantize::quantize(
              {.width = map.width, .height = map.height, .polynomials = polynomials, .coef = real},
              config, method, quantize::hemisphere_gram()),
          import.why_not};
}

golden::PtmMap to_ptm(const quantize::StoredMap& stored, golden::MapKind kind,
                      std::vector<std::uint8_t> color) {
  golden::PtmMap map;
  map.kind = kind;
  map.width = stored.width;
  map.height = stored.height;
  for (std::size_t i = 0; i < quantize::kSix; ++i) {
    map.scale[i] = std::ldexp(1.0, -stored.shift[i]);
    map.bias[i] = stored.bias[i];
  }
  map.coef.resize(stored.coef.size());
  std::transform(stored.coef.begin(), stored.coef.end(), map.coef.begin(), [](std::uint16_t c) {
    if (c > 255) throw std::invalid_argument("a .ptm holds coefficients of 8 bits");
    return static_cast<std::uint8_t>(c);
  });
  map.color = std::move(color);
  return map;
}

}  // namespace ptm::testbench
