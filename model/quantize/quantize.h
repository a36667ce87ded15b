#pragma once
#include "model/quantize/gram.h"
#include "model/quantize/grid.h"
#include "model/quantize/maps.h"
#include "model/reference/eval_config.h"

namespace ptm::quantize {

enum class Method : std::uint8_t { plain, nearest_plane };

/// Stores a map of real coefficients.
///
/// The polynomials are rounded from a5 down to a0. With R the factor of the lights' Gram matrix
/// (R^T R = G), `nearest_plane` rounds not a_i but
///
///     target_i = a_i - sum over j > i of R_ij / R_ii * (stored_j - a_j)
///
/// so that every rounding and every saturation is made up for by the coefficients still open
/// (Babai's nearest-plane rule). The mean squared error of the luminance is then exactly
/// sum of R_ii^2 (stored_i - target_i)^2. `plain` rounds the a_i themselves.
///
/// Shift and bias of each coefficient (of each group of coefficients, where they share a shift) are
/// those of least squared error, rounding and saturation together, over the targets that really
/// occur; a few outlying texels saturate, and are counted, rather than cost all others a bit
/// (model/quantize/choose_grid.h).
///
/// Error     per polynomial without saturation: the luminance's mean square over the lights is at
///           most sum of (R_ii 2^-shift_i)^2 / 4 (nearest_plane).
/// Requires  any configuration in the stated ranges; `gram` as gram_factor() wants it.
/// Bad input a coefficient that is not finite, wrong sizes: std::invalid_argument.
[[nodiscard]] StoredMap quantize(const RealMap& real, const reference::EvalConfig& config,
                                 Method method, const Gram& gram);

/// The same with bias and shift given: mip levels, palettes, a map in tiles.
[[nodiscard]] StoredMap quantize_on_grid(const RealMap& real, const Grid& grid,
                                         const reference::EvalConfig& config, Method method,
                                         const Gram& gram);

/// What a stored map changed. `rms` is over texels and lights, in levels; the rest by coefficient.
struct QuantizationError {
  double rms = 0;
  double psnr_db = 0;  ///< 20 log10(255 / rms); infinite if nothing changed
  double worst = 0;    ///< over lights, of the polynomial that changed most
  Six<double> coefficient_rms{};
  Six<double> coefficient_max{};
};
[[nodiscard]] QuantizationError compare(const RealMap& real, const StoredMap& stored,
                                        const Gram& gram);

/// Writes into a stored map what it lost against the real coefficients: rms_error, worst_error.
void record_loss(const RealMap& real, const Gram& gram, StoredMap& stored);

}  // namespace ptm::quantize
