#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "golden/files/image.h"

namespace ptm::testbench {

/// How far pictures b are from pictures a in some of their pixels, in 8-bit levels; each figure as
/// in PictureDifference.
struct PartDifference {
  std::uint64_t samples = 0, differing = 0;
  double max = 0, mean = 0, rmse = 0, psnr_db = 0;
};

/// The same pixels of every frame: those whose entry of `left_out`, [height][width], is 0. Nothing
/// if none remains. Frames are of one size and number (std::invalid_argument).
[[nodiscard]] std::optional<PartDifference> compare_without(
    std::span<const golden::ImageReal> a, std::span<const golden::ImageReal> b,
    const std::vector<std::uint8_t>& left_out);

}  // namespace ptm::testbench
