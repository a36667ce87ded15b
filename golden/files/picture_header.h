#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "golden/files/input_error.h"

namespace ptm::golden {

/// What a picture says of itself before it is decoded.
struct PictureHeader {
  int width = 0, height = 0;
  int channels = 0;     ///< as stored, alpha included
  std::string kind;     ///< "a picture (PNG)"
  std::string samples;  ///< OpenImageIO's name of their type: "uint8", "uint16", "float"
};

/// Reads no pixel. Throws InputError, as open_picture() does.
[[nodiscard]] PictureHeader read_picture_header(const std::filesystem::path& path);

/// Levels of one channel, 0..255 as read_picture() has them.
struct LevelRange {
  double least = 0, greatest = 0, mean = 0;
};

/// Of each channel that read_picture() keeps: one (grey) or three. Decodes the whole picture, some
/// rows at a time where its format allows that. Throws InputError, also for samples that are not
/// finite.
[[nodiscard]] std::vector<LevelRange> read_level_ranges(const std::filesystem::path& path);

}  // namespace ptm::golden
