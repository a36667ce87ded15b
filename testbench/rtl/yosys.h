#pragma once
#include <string>
#include <vector>

/// What every script for Yosys needs.
namespace ptm::testbench {

/// The files that a list such as rtl/files.f names, as seen from the project's root, in its order.
[[nodiscard]] std::vector<std::string> rtl_sources(const char* list);

/// The command that reads them.
[[nodiscard]] std::string read_verilog(const std::vector<std::string>& files);

/// A parameter's value: Yosys 0.23 reads no negative decimal.
[[nodiscard]] std::string yosys_integer(int value);

}  // namespace ptm::testbench
