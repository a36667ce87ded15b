#pragma once
#include <filesystem>
#include <string>
#include <vector>

/// Other programs.
namespace ptm::testbench {

/// Whether a program of that name lies in $PATH.
[[nodiscard]] bool find_program(const std::string& name);

/// Runs a program found in $PATH, in `folder`, without a shell, its output and errors into `log`
/// (overwritten; absolute, or as seen from `folder`), and returns its exit status; 128 and a
/// signal's number if one ended it. Throws std::system_error if it cannot be started.
int run_command(const std::vector<std::string>& command, const std::filesystem::path& log,
                const std::filesystem::path& folder = ".");

}  // namespace ptm::testbench
