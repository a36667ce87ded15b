#pragma once
#include <filesystem>

#include "golden/files/light_positions.h"

namespace ptm::golden {

/// The pictures of a folder under the lights of a plain table of numbers.
///
/// The table holds one light a line (N lines of 3 numbers) or one coordinate a line (3 lines of N
/// numbers); 3 x 3 is taken as one light a line, with a note. Blanks, tabs and commas part numbers;
/// blank lines and lines that begin with # are passed over. Lights are treated as in a .lp file.
///
/// Pictures are the folder's files whose extension OpenImageIO knows, hidden ones left out, in the
/// order of their names, with runs of digits compared as numbers; the n-th is lit by light n.
/// Throws InputError: a line that does not fit, a number that is none, another count of pictures.
[[nodiscard]] LightPositions read_light_table(const std::filesystem::path& table,
                                              const std::filesystem::path& folder);

/// The same for maps of one parameter, focus or time: one number a line or all in one line.
///
/// `direction` becomes (u, 0, 0). Numbers within -1..1 stand as they are; otherwise the least
/// becomes -1 and the greatest 1, with a note (Polynomial Texture Maps, section 4.2).
[[nodiscard]] LightPositions read_parameter_table(const std::filesystem::path& table,
                                                  const std::filesystem::path& folder);

/// Order of names with runs of digits compared as numbers: a2 before a10.
[[nodiscard]] bool natural_less(const std::string& a, const std::string& b);

}  // namespace ptm::golden
