#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "golden/files/input_error.h"

namespace ptm::golden {

/// A photograph and where its light stood.
struct LitPicture {
  std::filesystem::path picture;      ///< exists
  std::array<double, 3> direction{};  ///< unit vector to the light: x right, y up, z to the camera
  int line = 0;                       ///< in the .lp file, from 1
};

struct LightPositions {
  std::vector<LitPicture> pictures;  ///< at least one
  std::vector<std::string> notes;    ///< odd things met while reading, said to the user
};

/// Reads a .lp file: lines of "PICTURE X Y Z", the first line may be their number.
///
/// Accepted: blank lines, several blanks or tabs, blanks at line ends, CRLF, a byte order mark,
/// blanks within the picture's name, backslashes in its path. A picture is sought as written beside
/// the .lp file, then by its bare name there.
/// With a note: lights not of unit length (normalised), a count that is not the number of lines, a
/// light below the horizon (z < 0, left out).
/// Throws InputError with the line: a missing picture, fewer than four fields, a coordinate that is
/// no finite number, light (0, 0, 0); and if no light is left.
[[nodiscard]] LightPositions read_light_positions(const std::filesystem::path& path);

/// What read_light_positions reads of a file at `path`, names relative to its folder. The line
/// numbers are not used.
[[nodiscard]] std::string format_light_positions(const std::filesystem::path& path,
                                                 const std::vector<LitPicture>& pictures);
/// Writes that to a temporary name, then renames. Throws InputError if it cannot be written.
void write_light_positions(const std::filesystem::path& path,
                           const std::vector<LitPicture>& pictures);

}  // namespace ptm::golden
