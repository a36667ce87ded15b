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
  int line = 0;                       ///< in the list, from 1
  std::array<double, 3> position{};   ///< the vector as the list has it, before it was normalised
};

struct LightPositions {
  std::vector<LitPicture> pictures;  ///< at least one
  std::vector<std::string> notes;    ///< odd things met while reading, said to the user
};

/// Where the pictures of a list of lights are, if not where the list says.
struct PictureSource {
  std::filesystem::path folder;  ///< not empty: this folder's pictures, by order of names
  bool skip_missing = false;     ///< lights whose picture is missing are left out
  bool positions = false;        ///< the vectors' lengths are meant: no note about them
};

/// Reads a .lp file: lines of "PICTURE X Y Z", the first line may be their number.
///
/// Accepted: what read_text_lines() and read_light_line() do, blank lines, lines that begin with #
/// and hold no light. Pictures are found as ListedPictures says.
/// The count rules: lines beyond it are not read, and a note says so, as it does of a count above
/// the number of lines.
/// With a note: names of another case or folder, decimal commas, a line of column names at the
/// beginning, lights not of unit length, a light below the horizon (z < 0, left out).
///
/// With a folder in `source`, the names of the list give their order only: the light of the n-th
/// name belongs to the folder's n-th picture, both in natural order of names, and the folder has as
/// many pictures as the list has lights. A note says if the list itself is in another order.
/// With `skip_missing`, lights without a picture are left out and a note names them; six must
/// remain, or two of a list of fewer.
///
/// Throws InputError with the line: a missing picture, fewer than four fields, a coordinate that is
/// no finite number, light (0, 0, 0); and if no light is left.
[[nodiscard]] LightPositions read_light_positions(const std::filesystem::path& path,
                                                  const PictureSource& source = {});

/// What read_light_positions reads of a file at `path`, names relative to its folder. The line
/// numbers are not used.
[[nodiscard]] std::string format_light_positions(const std::filesystem::path& path,
                                                 const std::vector<LitPicture>& pictures);
/// Writes that to a temporary name, then renames. Throws InputError if it cannot be written.
void write_light_positions(const std::filesystem::path& path,
                           const std::vector<LitPicture>& pictures);

}  // namespace ptm::golden
