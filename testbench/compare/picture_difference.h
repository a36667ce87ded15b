#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "golden/files/image.h"

namespace ptm::testbench {

/// Where two pictures differ most.
struct WorstPixel {
  int frame = 0, x = 0, y = 0;
  double error = 0;  ///< levels: the largest |b - a| of the pixel's channels
  bool operator==(const WorstPixel&) const = default;
};

/// Signed errors b - a, counted in bins around zero: bin i holds (c - w/2 <= e < c + w/2) with
/// c = (i - half_bins) * w. The width w is a power of two, the least that needs no more than
/// 32 bins a side, but at least 1/32, and at least 1 if all samples of both sides are integers.
struct ErrorHistogram {
  double bin_width = 1;                     ///< levels
  int half_bins = 0;                        ///< bins on each side of the middle one
  std::vector<std::uint64_t> counts = {0};  ///< 2 * half_bins + 1
  [[nodiscard]] double center(std::size_t bin) const {
    return (static_cast<double>(bin) - half_bins) * bin_width;
  }
};

/// How far picture b is from picture a, in 8-bit levels; definitions in docs/spec/report.md.
struct PictureDifference {
  std::uint64_t samples = 0;    ///< pixels * channels * frames
  std::uint64_t differing = 0;  ///< samples whose 8-bit values differ, see level8()
  double share = 0;             ///< differing / samples
  double max = 0;               ///< largest |b - a|
  double mean = 0;              ///< mean |b - a|
  double rmse = 0;              ///< sqrt(mean (b - a)^2)
  double psnr_db = 0;           ///< 20 log10(255 / rmse); infinity if rmse = 0
  double ssim = 0;              ///< structural_similarity(), mean over the frames
  ErrorHistogram histogram;
  std::vector<WorstPixel> worst;  ///< up to ten that differ: by error, then frame, y, x
};

/// The 8-bit value of a sample: clamp(floor(x + 1/2), 0, 255). An integer within 0..255 is its own,
/// so between two models of hardware "8-bit values differ" is plainly "values differ".
[[nodiscard]] constexpr int level8(double x) noexcept {
  // No value, NaN included, is cast out of range, and nothing branches.
  const double above = x > 0 ? x : 0;
  return static_cast<int>((above < 255 ? above : 255) + 0.5);
}

/// Compares sequences of pictures as one: counts, means and the histogram run over all frames.
/// Throws std::invalid_argument, naming what and where, if there is no frame or no pixel, if the
/// numbers of frames or the sizes differ, if channels are not 1 or 3, or a sample is not finite.
[[nodiscard]] PictureDifference compare_frames(std::span<const golden::ImageReal> a,
                                               std::span<const golden::ImageReal> b);
[[nodiscard]] PictureDifference compare_pictures(const golden::ImageReal& a,
                                                 const golden::ImageReal& b);

}  // namespace ptm::testbench
