#include "testbench/rtl/unit_cells.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "testbench/rtl/command.h"
#include "testbench/rtl/variant_build.h"
#include "testbench/rtl/variant_cache.h"
#include "testbench/rtl/work_folder.h"
#include "testbench/rtl/yosys.h"

namespace ptm::testbench {
namespace {

namespace fs = std::filesystem;

std::string script(const std::vector<std::string>& parameters, const fs::path& root) {
  std::vector<std::string> files = listed_sources(root, "rtl/files.f");
  for (const std::string& file : listed_sources(root, "rtl/unit.f")) files.push_back(file);
  for (const std::string& file : variant_build().effect_files) files.push_back(file);
  std::string text = read_verilog(files) + "; chparam";
  for (const std::string& parameter : parameters) {
    const std::size_t at = parameter.find('=');
    text += " -set " + parameter.substr(0, at) + " " +
            yosys_integer(std::stoi(parameter.substr(at + 1)));
  }
  return text + " ptm_unit; hierarchy -check -top ptm_unit; proc; opt_clean; stat";
}

/// Of the whole design, which `stat` prints last: "$mul   368", "Number of cells:   7984".
UnitCells read_counts(const fs::path& log) {
  std::ifstream file(log);
  UnitCells counts;
  bool whole = false;
  for (std::string line; std::getline(file, line);) {
    if (line.find("=== design hierarchy ===") != std::string::npos) whole = true;
    if (!whole) continue;
    const std::size_t last = line.find_last_not_of("0123456789");
    if (last == std::string::npos || last + 1 == line.size()) continue;
    const std::uint64_t number = std::stoull(line.substr(last + 1));
    std::string name;
    std::istringstream(line) >> name;
    if (line.find("Number of cells:") != std::string::npos) counts.cells = number;
    if (line.find("Number of memory bits:") != std::string::npos) counts.memory_bits = number;
    if (name == "$mul") counts.multipliers = number;
    if (name == "$add" || name == "$sub") counts.adders += number;
  }
  return counts;
}

}  // namespace

UnitCells count_unit_cells(const reference::EvalConfig& config, const reference::UnitConfig& unit) {
  if (!find_program("yosys")) {
    throw ToolError("to count cells yosys is needed: install the package yosys");
  }
  const WorkFolder work(fs::temp_directory_path() / "ptmsim-cells");
  unpack_sources(work.path());
  const fs::path log = work.path() / "log";
  const int status = run_command({"yosys", "-p", script(rtl_parameters(config, unit), work.path())},
                                 log, work.path(), {"TMPDIR=" + work.path().string()});
  const UnitCells counts = read_counts(log);
  if (status != 0 || counts.cells == 0) throw ToolError("yosys failed to read the RTL");
  return counts;
}

}  // namespace ptm::testbench
