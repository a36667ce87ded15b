#pragma once
#include <filesystem>

#include "golden/files/light_positions.h"

namespace ptm::golden {

/// The pictures of a folder under the lights of a plain table of numbers.
///
/// The table holds one light a line (N lines of 3 numbers) or one coordinate a line (3 lines of N
/// numbers); 3 x 3 is taken as one light a line, with a note. Numbers are read as
/// read_number_table() says. A row of names may say which columns are x, y and z (or lx, ly, lz);
/// others are dropped. A count may come first, and rules as in a .lp file. Lights are treated as
/// there.
///
/// The n-th light belongs to the n-th picture of the folder: pictures_of().
/// With `positions` the vectors' lengths are meant, and no note is made of them.
/// Throws InputError: a line that does not fit, a number that is none, another count of pictures.
[[nodiscard]] LightPositions read_light_table(const std::filesystem::path& table,
                                              const std::filesystem::path& folder,
                                              bool positions = false);

/// The same for maps of one parameter, focus or time: one number a line or all in one line; the
/// first may be the count of the others, if there are as many pictures as those.
///
/// `direction` becomes (u, 0, 0). Numbers within -1..1 stand as they are; otherwise the least
/// becomes -1 and the greatest 1, with a note (Polynomial Texture Maps, section 4.2).
[[nodiscard]] LightPositions read_parameter_table(const std::filesystem::path& table,
                                                  const std::filesystem::path& folder);

}  // namespace ptm::golden
