#pragma once
#include <array>
#include <span>
#include <vector>

#include "golden/fit/fit_lrgb.h"

namespace ptm::golden {

/// Distance between a map's rendering and a photograph or all of them, in levels.
struct Residual {
  double rmse = 0;
  double psnr_db = 0;                    ///< 20 log10(255 / rmse); infinite if nothing differs
  std::array<double, 3> channel_rmse{};  ///< red, green, blue
};

struct FitReport {
  Residual all;
  std::vector<Residual> lights;  ///< one a photograph, in order of the capture
};

/// Renders an LRGB map under the lights of the photographs, each channel clamp(rgb * L / 255, 0,
/// 255) and not rounded, and compares. Coefficients [height][width][6], colour [height][width][3].
/// Sizes that do not agree with the capture throw std::invalid_argument.
[[nodiscard]] FitReport compare_lrgb(const Capture& capture, std::span<const double> coef,
                                     std::span<const std::uint8_t> color);

}  // namespace ptm::golden
