#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "model/reference/eval_config.h"
#include "testbench/rtl/yosys.h"

/// Calling the hardware tools on the sources of rtl/.
namespace ptm::tests {

/// The files of such a list, as they are written there.
inline std::vector<std::string> rtl_files(const std::string& list = "rtl/files.f") {
  return testbench::listed_sources(PTM_SOURCE_DIR, list);
}

/// The stages of effects and their chain, which no list names.
inline std::vector<std::string> effect_files() {
  std::vector<std::string> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(PTM_SOURCE_DIR) + "/rtl/effects")) {
    files.push_back("rtl/effects/" + entry.path().filename().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// A file of this process alone: tests run side by side.
inline std::string scratch_file(const std::string& name) {
  return testing::TempDir() + std::to_string(getpid()) + "_" + name;
}

struct ToolRun {
  int status = -1;
  std::string output;  ///< both streams
};

/// Runs a command in the source folder.
inline ToolRun run_tool(const std::string& command) {
  ToolRun run;
  const std::string line = "cd '" + std::string(PTM_SOURCE_DIR) + "' && " + command + " 2>&1";
  FILE* pipe = popen(line.c_str(), "r");
  if (pipe == nullptr) return run;
  char buffer[4096];
  for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) {
    run.output.append(buffer, n);
  }
  run.status = pclose(pipe);
  return run;
}

}  // namespace ptm::tests
