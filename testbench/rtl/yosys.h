#pragma once
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

/// What every script for Yosys needs.
namespace ptm::testbench {

/// The files that a list such as rtl/files.f names, as seen from the project's root, in its order.
[[nodiscard]] inline std::vector<std::string> listed_sources(const std::filesystem::path& root,
                                                             const std::string& list) {
  std::ifstream file(root / list);
  std::vector<std::string> files;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line.rfind("//", 0) != 0) files.push_back(line);
  }
  return files;
}

/// The same of the root that this build was made from.
[[nodiscard]] std::vector<std::string> rtl_sources(const std::string& list);

/// The command that reads them.
[[nodiscard]] inline std::string read_verilog(const std::vector<std::string>& files) {
  std::string command = "read_verilog -sv -Irtl";
  for (const std::string& file : files) command += " \"" + file + "\"";
  return command;
}

/// A parameter's value: Yosys 0.23 reads no negative decimal.
[[nodiscard]] inline std::string yosys_integer(int value) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "32'sh%08x", static_cast<unsigned>(value));
  return text.data();
}

}  // namespace ptm::testbench
