#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "golden/files/image.h"

namespace ptm::golden {

/// Photographs of one thing from one place, each under one light.
struct Capture {
  int width = 0;
  int height = 0;
  std::vector<std::string> names;                 ///< one a photograph
  std::vector<std::array<double, 3>> directions;  ///< unit vectors to the lights
  std::vector<Image<float>> photographs;  ///< RGB in 8-bit levels; grey pictures have R = G = B
  std::vector<std::string> notes;         ///< what was odd about the input, said to the user
};

/// Reads a .lp file and its photographs, as many at once as there are cores.
/// Throws InputError: what read_light_positions() and read_picture() throw, and photographs of
/// different sizes (the .lp file's line is named), and samples that are not finite.
[[nodiscard]] Capture read_capture(const std::filesystem::path& lp);

}  // namespace ptm::golden
