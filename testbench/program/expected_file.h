#pragma once
#include <filesystem>

#include "golden/files/file_kind.h"

namespace ptm::testbench {

/// Throws InputError if a file is of a known kind other than `wanted`: the message says what it is
/// and which command takes it. A file that is not there, or of no known kind, is left to the reader
/// that will open it.
void expect_file(const std::filesystem::path& path, golden::FileType wanted);

/// The same for `info`, which takes maps and pictures; returns which of the two it is. A file of no
/// known kind is refused here.
[[nodiscard]] golden::FileType expect_map_or_picture(const std::filesystem::path& path);

/// Refuses the name of a map that is to be written if its extension is a picture's or a scene's.
void expect_map_name(const std::filesystem::path& path);

}  // namespace ptm::testbench
