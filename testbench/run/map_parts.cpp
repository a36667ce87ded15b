#include "testbench/run/map_parts.h"

#include <algorithm>
#include <cmath>

#include "model/quantize/gain.h"
#include "model/quantize/mip.h"
#include "model/quantize/quantize.h"

namespace ptm::testbench {
namespace {

std::vector<std::uint8_t> to_bytes(const std::vector<double>& values) {
  std::vector<std::uint8_t> bytes(values.size());
  std::transform(values.begin(), values.end(), bytes.begin(), [](double value) {
    return static_cast<std::uint8_t>(std::clamp(std::floor(value + 0.5), 0.0, 255.0));
  });
  return bytes;
}

}  // namespace

std::vector<std::vector<std::uint8_t>> halve_bytes(const std::vector<std::uint8_t>& top, int width,
                                                   int height, int channels, int levels) {
  std::vector<std::vector<std::uint8_t>> all{top};
  std::vector<double> values(top.begin(), top.end());
  for (int level = 1; level < levels; ++level) {
    values = quantize::halve(values, width, height, channels);
    width = quantize::half_side(width);
    height = quantize::half_side(height);
    all.push_back(to_bytes(values));
  }
  return all;
}

PalettizedMap palettize(const quantize::RealMap& map, std::span<const std::uint8_t> color,
                        const quantize::PaletteOptions& options,
                        const reference::EvalConfig& config, Strength strength) {
  const quantize::Gram gram = quantize::hemisphere_gram();
  // Beyond 1e9 no shift holds a coefficient anyway, and squares stay finite.
  std::vector<double> real(map.coef.begin(), map.coef.end());
  for (double& a : real) a = std::clamp(a, -1e9, 1e9);
  std::vector<double> coef = real, weights;
  const bool colored = map.polynomials == 1;
  if (colored) {
    const std::vector<double> factors = strength == Strength::may_move
                                            ? quantize::equalize_strength(coef, color, gram)
                                            : std::vector<double>(color.size() / 3, 1.0);
    weights = quantize::color_weights(color, factors);
  }
  const quantize::RealMap even{map.width, map.height, map.polynomials, coef};
  PalettizedMap made;
  made.palette = quantize::make_palette(even, weights, options, gram);
  made.table =
      quantize::quantize(made.palette.view(), config, quantize::Method::nearest_plane, gram);
  made.stored = quantize::store_palette(even, made.palette, {made.table.bias, made.table.shift},
                                        config, gram);
  if (colored) {
    made.color = quantize::refit_colors(real, quantize::dequantize(made.stored), color, gram);
  }
  return made;
}

}  // namespace ptm::testbench
