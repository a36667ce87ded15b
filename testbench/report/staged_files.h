#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ptm::testbench {

/// Files of one directory that appear together or not at all: each is written under a temporary
/// name beside its target, commit() renames them in the order they were written. Without commit()
/// the temporary files are removed.
class StagedFiles {
 public:
  /// Creates the directory, and those above it, if missing. Throws golden::InputError if it cannot.
  explicit StagedFiles(std::filesystem::path directory);
  ~StagedFiles();
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;

  /// Throws golden::InputError naming the file (a full disk, no permission).
  void write(const std::string& name, std::string_view bytes);
  void write(const std::string& name, std::span<const std::uint8_t> bytes);
  void commit();

 private:
  struct Staged {
    std::filesystem::path temporary, target;
  };
  std::filesystem::path directory_;
  std::vector<Staged> staged_;
};

}  // namespace ptm::testbench
