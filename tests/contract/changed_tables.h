#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>

#include "tests/scratch_folder.h"

namespace ptm::tests {

inline std::string whole_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// How a command ended, and what it said on either stream.
struct Ended {
  int code = -1;
  std::string said;
};

/// A copy of the contract's tables, to be changed, and what the generator makes of it.
class ChangedTables {
 public:
  ChangedTables() {
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(PTM_SOURCE_DIR) + "/contract")) {
      if (entry.path().extension() != ".toml") continue;
      scratch_.write("tables/" + entry.path().filename().string(), whole_text(entry.path()));
    }
  }

  void append(const std::string& table, const std::string& rows) {
    std::ofstream(scratch_ / ("tables/" + table), std::ios::app) << rows;
  }
  /// The first place; returns the line it begins in.
  long replace(const std::string& table, const std::string& from, const std::string& to) {
    std::string text = whole_text(scratch_ / ("tables/" + table));
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at == std::string::npos) return 0;
    const auto begin = text.begin();
    const long line = 1 + std::count(begin, begin + static_cast<std::ptrdiff_t>(at), '\n');
    scratch_.write("tables/" + table, text.replace(at, from.size(), to));
    return line;
  }

  /// Runs a command in the repository.
  [[nodiscard]] Ended run(const std::string& command) const {
    const std::filesystem::path log = scratch_ / "log";
    const std::string line = std::string("cd '") + PTM_SOURCE_DIR + "' && (" + command + ") >'" +
                             log.string() + "' 2>&1";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, whole_text(log)};
  }
  /// What is for the build lies in include/contract then, the rest in include/contract/committed.
  [[nodiscard]] Ended generate() const {
    return run(std::string(PTM_CONTRACT) + " '" + (scratch_ / "tables").string() + "' '" +
               (scratch_ / "include/contract").string() + "'");
  }
  [[nodiscard]] std::filesystem::path committed(const std::string& path) const {
    return scratch_ / ("include/contract/committed/" + path);
  }
  [[nodiscard]] const ScratchFolder& scratch() const { return scratch_; }

 private:
  ScratchFolder scratch_;
};

}  // namespace ptm::tests
