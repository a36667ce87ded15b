#pragma once
#include <array>
#include <span>

#include "golden/files/ptm_map.h"

namespace ptm::testbench {

/// How two maps' pictures differ under lights, by the golden renderer, in levels.
struct LitDifference {
  double rmse = 0;
  double psnr_db = 0;        ///< 20 log10(255 / rmse); infinite if nothing differs
  double max = 0;            ///< largest difference of a channel
  double within_999 = 0;     ///< 99.9 % of the channels' samples differ by no more, in 1/8 levels
  double ssim = 1;           ///< structural_similarity(), mean over lights
  double ssim_least = 1;     ///< of the worst light
  double visible_share = 0;  ///< of samples that differ by more than 5 levels (2 %)
};

/// Maps of one size, at least one light (std::invalid_argument). Lights are (lu, lv).
[[nodiscard]] LitDifference compare_lit(const golden::PtmMap& a, const golden::PtmMap& b,
                                        std::span<const std::array<double, 2>> lights);

/// The lights that maps are compared under unless somebody says otherwise: 24 directions spread
/// evenly over the hemisphere, 10 degrees above the horizon and more.
[[nodiscard]] std::span<const std::array<double, 2>> comparison_lights();

}  // namespace ptm::testbench
