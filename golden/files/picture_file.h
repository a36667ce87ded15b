#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "golden/files/image.h"
#include "golden/files/input_error.h"

namespace ptm::golden {

/// Reads any picture OpenImageIO reads, 1 or 3 channels kept (alpha dropped), as 8-bit levels:
/// 8-bit files give their integers, 16-bit and float ones are scaled to 0..255 without rounding.
/// It is turned and mirrored as its tag Orientation (Exif, TIFF) says; colours that mean
/// directions, a normal map's, are taken as those of the turned picture. Throws InputError.
[[nodiscard]] ImageReal read_picture(const std::filesystem::path& path);

/// The same as red, green, blue and alpha; grey fills all three colours. Alpha is 255 where the
/// file has none, and is not multiplied in.
[[nodiscard]] ImageReal read_picture_with_alpha(const std::filesystem::path& path);

/// A picture file of 8-bit samples in the format of the path's extension; nothing is written to
/// that path. Throws InputError where the format cannot hold them.
[[nodiscard]] std::vector<std::uint8_t> encode_picture(const std::filesystem::path& path,
                                                       const Image8& image);

/// Writes those bytes to a temporary name, then renames.
void write_picture(const std::filesystem::path& path, const Image8& image);

}  // namespace ptm::golden
