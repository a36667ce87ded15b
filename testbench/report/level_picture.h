#pragma once
#include "golden/files/image.h"

namespace ptm::testbench {

/// The picture to look at: every sample as level8(). With block > 1 each of its pixels is the mean
/// of block x block pixels (fewer at the right and lower edge), then level8().
[[nodiscard]] golden::Image8 level_picture(const golden::ImageReal& image, int block = 1);

/// The least whole factor that brings the longer side down to `side` pixels.
[[nodiscard]] int reduction_to(int width, int height, int side);

}  // namespace ptm::testbench
