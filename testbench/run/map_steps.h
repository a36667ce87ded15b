#pragma once
#include <string>
#include <vector>

#include "golden/files/ptm_map.h"
#include "model/quantize/dither.h"
#include "model/quantize/palette.h"
#include "model/reference/eval_config.h"

/// What turns one map into another: `ptmsim convert`'s steps. All results are maps that the
/// configuration takes verbatim; it must hold coefficients of 8 bits, as files do.
namespace ptm::testbench {

/// A map and what making it changed.
struct SteppedMap {
  golden::PtmMap map;
  std::string how;  ///< one sentence for the user
};

/// The map as the configuration holds it: unchanged where it is taken verbatim, otherwise quantised
/// (a lum map as rgb), with dither if wanted.
[[nodiscard]] SteppedMap hold_map(const golden::PtmMap& map, const reference::EvalConfig& config,
                                  quantize::Dither dither);

/// One polynomial a channel, quantised anew; an rgb map is held as it is.
[[nodiscard]] SteppedMap to_rgb_map(const golden::PtmMap& map, const reference::EvalConfig& config,
                                    quantize::Dither dither);

/// The map with at most `entries` different polynomials (lrgb) or triples of them (rgb). An lrgb
/// map's entries tell how a texel answers to light, its colour how strongly
/// (model/quantize/gain.h).
[[nodiscard]] SteppedMap palette_map(const golden::PtmMap& map, const reference::EvalConfig& config,
                                     const quantize::PaletteOptions& options);

/// The map as held and its mip levels down to 1 x 1, all on one grid. Coefficients and colours are
/// averaged apart, as the texture unit filters them.
[[nodiscard]] std::vector<golden::PtmMap> mip_chain(const golden::PtmMap& map,
                                                    const reference::EvalConfig& config);

}  // namespace ptm::testbench
