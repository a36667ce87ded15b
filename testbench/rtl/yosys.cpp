#include "testbench/rtl/yosys.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "testbench/rtl/variant_build.h"

namespace ptm::testbench {

std::vector<std::string> rtl_sources(const char* list) {
  std::ifstream file(std::filesystem::path(variant_build().source_root) / list);
  std::vector<std::string> files;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line.rfind("//", 0) != 0) files.push_back(line);
  }
  return files;
}

std::string read_verilog(const std::vector<std::string>& files) {
  std::string command = "read_verilog -sv -Irtl";
  for (const std::string& file : files) command += " \"" + file + "\"";
  return command;
}

std::string yosys_integer(int value) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "32'sh%08x", static_cast<unsigned>(value));
  return text.data();
}

}  // namespace ptm::testbench
