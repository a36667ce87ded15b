#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "golden/files/input_error.h"

namespace ptm::golden {

/// The most bytes that are read of a file as a whole, unless a reader states less: the largest raw
/// map of 2^28 texels (RGB, 18 bytes each) and its header.
inline constexpr std::uintmax_t kLargestFile = (std::uintmax_t{18} << 28) + (1 << 20);
/// The most bytes of a list of lights, a table or a scene.
inline constexpr std::uintmax_t kLargestText = std::uintmax_t{16} << 20;

/// Throws InputError unless `path` is a plain file, or a link to one. Folders, pipes, devices and
/// sockets are refused by that name: reading them might block, or never end. `what` names the
/// expected kind of file: "a .ptm file".
void require_plain_file(const std::filesystem::path& path, const std::string& what);

/// Reads a file that must begin with `magic`; a file that does not is refused before the rest is
/// read. Throws InputError as require_plain_file() does, for a file of more than `most_bytes`
/// (before it is read), and where reading fails before the file's end.
[[nodiscard]] std::vector<std::uint8_t> read_whole_file(const std::filesystem::path& path,
                                                        std::string_view magic,
                                                        const std::string& what,
                                                        std::uintmax_t most_bytes = kLargestFile);

/// The first `count` bytes of a plain file, or all if it has fewer. It must begin with `magic`.
/// Throws InputError as read_whole_file() does.
[[nodiscard]] std::vector<std::uint8_t> read_file_head(const std::filesystem::path& path,
                                                       const std::string& what,
                                                       std::string_view magic, std::size_t count,
                                                       std::uintmax_t most_bytes = kLargestFile);

/// As read_whole_file(), for a file of text without a mark at its beginning.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path, const std::string& what,
                                         std::uintmax_t most_bytes = kLargestText);

}  // namespace ptm::golden
