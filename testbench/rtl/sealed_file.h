#pragma once
#include <filesystem>

/// Files that end in a digest of what is before it, so that damage is found. A loader of libraries
/// does not look beyond the sections, and code from a damaged one ends the program.
namespace ptm::testbench {

/// Appends the digest. Throws std::system_error.
void seal_file(const std::filesystem::path& path);

/// Whether it is a plain file as it was sealed. False if it is missing or cannot be read.
[[nodiscard]] bool is_sealed(const std::filesystem::path& path);

}  // namespace ptm::testbench
