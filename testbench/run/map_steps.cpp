#include "testbench/run/map_steps.h"

#include <numeric>
#include <sstream>

#include "golden/files/figure_text.h"
#include "model/quantize/mip.h"
#include "testbench/run/hardware_map.h"
#include "testbench/run/map_parts.h"

namespace ptm::testbench {
namespace {

using golden::MapKind;
using golden::PtmMap;
using reference::EvalConfig;

/// A map's real coefficients and colours, and the grid that holds them.
struct Held {
  quantize::StoredMap stored;
  RealCoefficients real;
  std::vector<std::uint8_t> color;
  MapKind kind = MapKind::lrgb;
  std::string how;

  [[nodiscard]] quantize::RealMap view() const {
    return {stored.width, stored.height, stored.polynomials, real.coef};
  }
  [[nodiscard]] quantize::Grid grid() const { return {stored.bias, stored.shift}; }
  [[nodiscard]] PtmMap map() const { return to_ptm(stored, kind, color); }
};

std::string describe(const quantize::StoredMap& stored) {
  std::ostringstream text;
  text << "rms change of the luminance "
       << golden::count_of(golden::four_digits(stored.rms_error), "level") << ", "
       << golden::four_digits(stored.worst_error) << " at the worst polynomial, "
       << golden::count_of(
              std::accumulate(stored.saturated.begin(), stored.saturated.end(), std::uint64_t{0}),
              "coefficient")
       << " saturated";
  return text.str();
}

quantize::StoredMap store(const quantize::RealMap& real, const EvalConfig& config,
                          quantize::Dither dither) {
  const quantize::Gram gram = quantize::hemisphere_gram();
  quantize::StoredMap stored =
      quantize::quantize(real, config, quantize::Method::nearest_plane, gram);
  if (dither == quantize::Dither::none) return stored;
  return quantize::quantize_dithered(real, {stored.bias, stored.shift}, config, dither, gram);
}

Held hold(const PtmMap& map, const EvalConfig& config,
          quantize::Dither dither = quantize::Dither::none) {
  Held held;
  held.kind = map.kind == MapKind::lrgb ? MapKind::lrgb : MapKind::rgb;
  quantize::Import import = import_map(map, config);
  if (import.map) {
    held.stored = std::move(*import.map);
    held.real = real_polynomials(map);
    held.color = map.color;
    held.how = "taken verbatim";
    return held;
  }
  QuantizerInput input = quantizer_input(map, config);
  held.real = std::move(input.real);
  held.color = std::move(input.color);
  held.stored =
      store({map.width, map.height, static_cast<int>(held.real.polynomials), held.real.coef},
            config, dither);
  require_held(held.stored.rms_error, "the map");
  held.how = "quantised because " + import.why_not + "; " + describe(held.stored);
  if (input.balance.scaled > 0) {
    held.how += "; colour scaled up and luminance down in " + std::to_string(input.balance.scaled) +
                " texels";
  }
  return held;
}

}  // namespace

SteppedMap hold_map(const PtmMap& map, const EvalConfig& config, quantize::Dither dither) {
  const Held held = hold(map, config, dither);
  return {held.map(), held.how};
}

SteppedMap to_rgb_map(const PtmMap& map, const EvalConfig& config, quantize::Dither dither) {
  if (map.kind != MapKind::lrgb) return hold_map(map, config, dither);
  const RealCoefficients rgb = rgb_polynomials(map);
  const quantize::StoredMap stored = store({map.width, map.height, 3, rgb.coef}, config, dither);
  require_held(stored.rms_error, "the map");
  return {to_ptm(stored, MapKind::rgb, {}), "colour multiplied in; " + describe(stored)};
}

SteppedMap palette_map(const PtmMap& map, const EvalConfig& config,
                       const quantize::PaletteOptions& options) {
  const Held held = hold(map, config);
  PalettizedMap made = palettize(held.view(), held.color, options, config);
  std::ostringstream how;
  how << "a palette of " << golden::count_of(made.palette.entries(), "entry") << " after "
      << golden::count_of(made.palette.rounds, "round") << " of k-means, seed " << options.seed
      << "; " << describe(made.stored);
  return {to_ptm(made.stored, held.kind, std::move(made.color)), how.str()};
}

std::vector<PtmMap> mip_chain(const PtmMap& map, const EvalConfig& config) {
  const Held held = hold(map, config);
  std::vector<PtmMap> chain{held.map()};
  const std::vector<quantize::RealLevel> levels = quantize::mip_levels(held.view());
  std::vector<std::vector<std::uint8_t>> colors(levels.size() + 1);
  if (held.kind == MapKind::lrgb) {
    colors = halve_bytes(held.color, map.width, map.height, 3, static_cast<int>(colors.size()));
  }
  for (std::size_t l = 0; l < levels.size(); ++l) {
    chain.push_back(to_ptm(
        quantize::quantize_on_grid(levels[l].view(), held.grid(), config,
                                   quantize::Method::nearest_plane, quantize::hemisphere_gram()),
        held.kind, std::move(colors[l + 1])));
  }
  return chain;
}

}  // namespace ptm::testbench
