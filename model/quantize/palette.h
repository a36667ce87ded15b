#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "model/quantize/gram.h"
#include "model/quantize/grid.h"
#include "model/quantize/maps.h"
#include "model/reference/eval_config.h"

namespace ptm::quantize {

struct PaletteOptions {
  int entries = 256;       ///< at most; 2..65536. The paper: 256 for LRGB, 4096 for RGB (section 5)
  std::uint64_t seed = 1;  ///< the same seed, map and options give the same palette
  int rounds = 16;         ///< of k-means at most; it stops when no texel moves
  std::size_t sample = 65536;  ///< texels that k-means looks at, spread by a hash; 0: all of them
  std::function<void()> step = {};  ///< called now and then, palette_steps() times at most
};

/// How often `step` is called at most: for a progress bar.
[[nodiscard]] int palette_steps(const PaletteOptions& options);

/// A table of polynomials and which of them each texel has.
struct Palette {
  int polynomials = 1;
  std::vector<double> coef;          ///< [entry][polynomials][6]; no more than asked for
  std::vector<std::uint16_t> index;  ///< [texel], all entries occur in the sample
  int rounds = 0;                    ///< that k-means took
  int refilled = 0;                  ///< clusters that fell empty on the way and got a new entry

  [[nodiscard]] int entries() const;
  [[nodiscard]] RealMap view() const;  ///< the table as a map, entries x 1
};

/// Clusters a map's texels by k-means (Polynomial Texture Maps, section 5).
///
/// Distance is what the eye could see: with R^T R = G (gram.h), |R (a - b)|^2 is the mean squared
/// difference of the luminance over the lights; an RGB texel's three add up. `weights`, one a texel
/// or none, say how much a texel's luminance shows: with |colour|^2 / 3 / 255^2 the distance of an
/// LRGB map is that of the picture.
///
/// First entries by k-means++ (Arthur, Vassilvitskii 2007). The generator hashes seed and draw, the
/// distances of a texel are summed in a fixed order in single precision and the means in double, so
/// neither threads nor the width of vectors change the result. A map of fewer different texels than
/// entries gives fewer entries. A cluster that falls empty gets the texel that is worst off.
///
/// Sizes that do not agree, options out of range, coefficients that are not finite, or weights that
/// are negative, not finite or all zero throw std::invalid_argument.
[[nodiscard]] Palette make_palette(const RealMap& map, std::span<const double> weights,
                                   const PaletteOptions& options, const Gram& gram);

/// The palette's entries stored on a grid and put in each texel's place: a map that any evaluator
/// takes. Its rms_error and worst_error are against `map`.
[[nodiscard]] StoredMap store_palette(const RealMap& map, const Palette& palette, const Grid& grid,
                                      const reference::EvalConfig& config, const Gram& gram);

}  // namespace ptm::quantize
