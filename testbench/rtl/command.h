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
/// signal's number if one ended it. `environment` is "NAME=value" of variables it has beside or in
/// place of ours. It reads nothing from standard input.
///
/// It ends before this function returns, with every process that it started, in any depth; also
/// when this process ends meanwhile, by whatever signal. A signal that golden::HeldSignals hold
/// back ends it, too. Throws std::system_error if it cannot be started.
int run_command(const std::vector<std::string>& command, const std::filesystem::path& log,
                const std::filesystem::path& folder = ".",
                const std::vector<std::string>& environment = {});

}  // namespace ptm::testbench
