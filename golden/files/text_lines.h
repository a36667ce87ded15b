#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "golden/files/whole_file.h"

namespace ptm::golden {

/// The lines of a text file, without their ends: LF, CRLF or CR alone (old Macintosh programs).
/// A byte order mark is dropped; UTF-16, which spreadsheets and PowerShell write, becomes UTF-8.
/// Throws InputError as read_text_file() does.
[[nodiscard]] std::vector<std::string> read_text_lines(const std::filesystem::path& path,
                                                       const std::string& what,
                                                       std::uintmax_t most_bytes = kLargestText);

}  // namespace ptm::golden
