#pragma once
#include "golden/files/image.h"

namespace ptm::testbench {

/// Structural similarity of two pictures, in 8-bit levels: 1 if they are equal.
///
///     SSIM = mean over windows of (2 ma mb + C1)(2 sab + C2)
///                                 / ((ma^2 + mb^2 + C1)(sa^2 + sb^2 + C2))
///     C1 = (0.01 * 255)^2,  C2 = (0.03 * 255)^2
///
/// Source   Wang, Bovik, Sheikh, Simoncelli, 2004: 11 x 11 Gaussian window, sigma 1.5, weights that
///          sum to 1, population variances.
/// On       luma of Rec. 709, 0.2126 R + 0.7152 G + 0.0722 B of the levels as they stand; a
///          picture of one channel is its own luma.
/// Edges    only windows that lie wholly inside the picture count, as in the paper.
/// Tiny     in a dimension of fewer than 11 samples the window shrinks to the largest odd size
///          that fits, its weights again summing to 1. At 1 x 1 the variances vanish and the
///          first factor alone remains.
/// Requires equal sizes, 1 or 3 channels, finite samples (compare_pictures checks them).
[[nodiscard]] double structural_similarity(const golden::ImageReal& a, const golden::ImageReal& b);

}  // namespace ptm::testbench
