#pragma once
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "testbench/rtl/yosys.h"
#include "tests/scratch_folder.h"

namespace ptm::tests {

/// The evaluator's files, or those given, with one text of one of them replaced, wherever it
/// stands.
class ChangedRtl {
 public:
  ChangedRtl(const std::string& file, const std::string& from, const std::string& to,
             std::vector<std::string> files = testbench::rtl_sources("rtl/files.f"))
      : files_(std::move(files)) {
    std::ostringstream content;
    content << std::ifstream(std::string(PTM_SOURCE_DIR) + '/' + file).rdbuf();
    std::string text = content.str();
    std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error(file + " does not hold " + from);
    for (; at != std::string::npos; at = text.find(from, at + to.size())) {
      text.replace(at, from.size(), to);
    }
    for (std::string& name : files_) {
      if (name == file) name = folder_.write("changed.sv", text).string();
    }
  }
  [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

 private:
  ScratchFolder folder_;
  std::vector<std::string> files_;
};

}  // namespace ptm::tests
