#pragma once
#include <cstdint>
#include <vector>

#include "golden/files/image.h"

namespace ptm::golden {

/// The picture as a PNG file in memory: 8 bits a sample, 1 channel (grey) or 3 (RGB), lossless,
/// the same bytes for the same picture.
/// Throws std::invalid_argument for another number of channels or no pixels at all, and
/// std::runtime_error with OpenImageIO's words if it cannot encode.
[[nodiscard]] std::vector<std::uint8_t> encode_png(const Image8& image);

}  // namespace ptm::golden
