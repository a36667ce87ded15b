#pragma once
#include "model/quantize/gram.h"
#include "model/quantize/grid.h"
#include "model/quantize/maps.h"
#include "model/reference/eval_config.h"

namespace ptm::quantize {

/// Stores a map on a grid by the nearest-plane rule, with dither: smooth slopes keep their mean
/// where rounding alone would turn them into steps. Each texel by itself comes out worse, so it is
/// off unless asked for.
///
///     diffused  a polynomial's six rounding errors go to its neighbours' polynomials: 7/16 right,
///               3/16, 5/16 and 1/16 below (Floyd, Steinberg 1976). The luminance is linear in the
///               coefficients, so this diffuses its error under every light at once; and what is
///               diffused is the error that nearest-plane rounding left, small in G.
///     ordered   each coefficient is rounded at a threshold from an 8 x 8 Bayer matrix instead of
///               1/2, coefficient i's turned on by i times the golden section, so that the six do
///               not step together.
///
/// A polynomial that saturates passes nothing on: its error cannot be made up for, and would smear.
/// `none` is quantize_on_grid() with Method::nearest_plane, to the integer. The same bad input
/// throws.
[[nodiscard]] StoredMap quantize_dithered(const RealMap& real, const Grid& grid,
                                          const reference::EvalConfig& config, Dither dither,
                                          const Gram& gram);

}  // namespace ptm::quantize
