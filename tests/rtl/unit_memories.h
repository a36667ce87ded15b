#pragma once
#include <map>
#include <optional>
#include <regex>

#include "testbench/rtl/yosys.h"
#include "tests/rtl/rtl_tools.h"
#include "tests/scratch_folder.h"

/// The memories of the whole unit as Yosys sees them: each is a ptm_memory_ram, which becomes block
/// RAM, or a ptm_memory_register_file of at most 2 kbit; no array of more than that becomes
/// flip-flops.
namespace ptm::tests {

inline constexpr std::size_t kSmall = 2048;  ///< bits

struct Memory {
  std::string module;
  std::size_t bits = 0;
  bool registered = false;  ///< every read port is
};

/// What a netlist in RTLIL keeps of arrays: those that are still memories, and the sums of the bits
/// of those that were taken apart (wires named as elements, by module and array).
struct Arrays {
  std::vector<Memory> memories;
  std::map<std::string, std::size_t> apart;
};

inline Arrays read_arrays(const std::string& rtlil) {
  static const std::regex element(R"(wire (?:width (\d+) )?.*\\(\S+)\[\d+\]$)");
  Arrays arrays;
  std::istringstream in(rtlil);
  std::string module;
  std::size_t width = 0, size = 0;
  bool inside = false, registered = false;
  for (std::string line; std::getline(in, line);) {
    std::smatch found;
    if (line.starts_with("module ")) module = line.substr(7);
    if (line.starts_with("  cell $mem_v2")) inside = true;
    const auto value = [&line](const char* name) -> std::optional<std::string> {
      const std::string start = std::string("    parameter \\") + name + ' ';
      if (!line.starts_with(start)) return std::nullopt;
      return line.substr(start.size());
    };
    if (inside) {
      if (const auto bits = value("WIDTH")) width = std::stoul(*bits);
      if (const auto words = value("SIZE")) size = std::stoul(*words);
      if (const auto clocked = value("RD_CLK_ENABLE")) {
        registered = clocked->find('0', clocked->find('\'') + 1) == std::string::npos;
      }
      if (line == "  end") {
        arrays.memories.push_back({module, width * size, registered});
        inside = false;
      }
    } else if (line.starts_with("  wire ") && std::regex_search(line, found, element)) {
      arrays.apart[module + ' ' + found[2].str()] +=
          found[1].matched ? std::stoul(found[1].str()) : 1;
    }
  }
  return arrays;
}

inline std::vector<std::string> unit_sources() {
  std::vector<std::string> files = rtl_files();
  for (const auto& more : {rtl_files("rtl/unit.f"), effect_files()}) {
    files.insert(files.end(), more.begin(), more.end());
  }
  return files;
}

inline std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

inline bool is_a(const Memory& memory, const std::string& module) {
  return memory.module.ends_with('\\' + module);
}

struct Unit {
  const char* name;
  const char* parameters;  ///< of chparam
};

class RtlMemories : public testing::TestWithParam<Unit> {
 protected:
  /// The unit with its memories found and their registers merged, and what is left of them after
  /// `mapping`.
  Arrays arrays(const std::string& mapping = "") {
    const std::string found = (folder_ / "found.il").string();
    if (!std::filesystem::exists(found)) {
      run(testbench::read_verilog(unit_sources()) + GetParam().parameters +
          "\nhierarchy -check -top ptm_unit\nproc\nopt_expr\nopt_clean\nopt_dff\nopt_clean\n"
          "memory -nomap\nwrite_rtlil " +
          found);
    }
    if (mapping.empty()) return read_arrays(contents(found));
    const std::string mapped = (folder_ / "mapped.il").string();
    run("read_rtlil " + found + "\n" + mapping + "\nwrite_rtlil " + mapped);
    return read_arrays(contents(mapped));
  }

  void expect_block_ram() {
    const Arrays found = arrays();
    std::size_t large = 0;
    for (const Memory& memory : found.memories) {
      SCOPED_TRACE(memory.module + ", " + std::to_string(memory.bits) + " bits");
      EXPECT_TRUE(is_a(memory, "ptm_memory_ram") || is_a(memory, "ptm_memory_register_file"));
      if (is_a(memory, "ptm_memory_ram")) {
        EXPECT_TRUE(memory.registered);
      } else {
        EXPECT_LE(memory.bits, kSmall);
      }
      large += memory.bits > kSmall;
    }
    EXPECT_GE(large, 4U);  // data banks, fragment FIFO, miss ring, palettes
    for (const auto& [name, bits] : found.apart) EXPECT_LE(bits, kSmall) << name;
    const std::string ice40 = "memory_libmap -lib +/ice40/brams.txt";
    const std::string xilinx =  // as synth_xilinx does for the 7 series
        "memory_libmap -lib +/xilinx/lutrams_xc5v.txt -lib +/xilinx/brams_xc4v.txt -D HAS_SIZE_36 "
        "-D HAS_CASCADE -D HAS_CONFLICT_BUG -D HAS_MIXWIDTH_SDP";
    for (const std::string& mapping : {ice40, xilinx}) {
      for (const Memory& memory : arrays(mapping).memories) {
        EXPECT_LE(memory.bits, kSmall) << memory.module << " is left to flip-flops by " << mapping;
      }
    }
  }

 private:
  void run(const std::string& script) {
    const ToolRun run = run_tool("yosys -q -s " + folder_.write("script", script + '\n').string());
    ASSERT_EQ(run.status, 0) << run.output;
  }
  ScratchFolder folder_;
};

}  // namespace ptm::tests
