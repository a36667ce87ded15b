#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "golden/fit/capture.h"
#include "golden/fit/light_solver.h"

namespace ptm::golden {

/// An LRGB map with real coefficients: rgb * L(u, v) / 255, L in levels.
struct LrgbFit {
  int width = 0;
  int height = 0;
  std::vector<double> coef;         ///< [height][width][6], a0 first
  std::vector<std::uint8_t> color;  ///< [height][width][3] R G B
};

/// Weights of red, green and blue in the luminance (Rec. 709, as HP's fitter has them).
inline constexpr std::array<double, 3> kLumaWeights{0.2125, 0.7154, 0.0721};

/// Photographs of some pixels, as the fit of a tile takes them.
struct PhotoTile {
  std::size_t texels = 0;
  std::vector<std::span<const float>> samples;  ///< [light], each [texel][3] R G B in levels
};

/// Fits the pixels of one tile; HP's recipe (docs/spec/ptm-format.md, "Fitter conventions").
///
///     y_i   = luma_i / max over i of luma_i
///     a     = 255 * inverse * y
///     color = 255 * clamp(sum_i rgb_i / 255 * y_i / sum_i y_i^2, 0, 1), rounded
///
/// so the brightest photograph of a pixel has L near 255, and the colour carries the albedo that
/// fits all photographs best. A pixel that is black in every photograph gets coefficients 0 and
/// colour 0: it renders black under every light.
///
/// Writes coef [texel][6] and color [texel][3]. Samples must be finite and not negative.
void fit_lrgb_tile(const PhotoTile& tile, const LightSolver& solver, std::span<double> coef,
                   std::span<std::uint8_t> color);

/// Fits a whole capture, tile by tile on all cores.
[[nodiscard]] LrgbFit fit_lrgb(const Capture& capture, const LightSolver& solver);

}  // namespace ptm::golden
