#pragma once
#include <cstdint>
#include <deque>
#include <filesystem>
#include <list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "golden/files/pending_file.h"

namespace ptm::testbench {

/// Files of one directory that appear together or not at all: each is written under a temporary
/// name beside its target (golden::PendingFile), commit() renames them in the order they were
/// written. Without commit() neither they stay nor a directory that was made for them.
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
  /// commit() removes that file of an earlier run between what was written before and after this.
  /// Anything else of that name stays.
  void remove(const std::string& name);
  /// Signals wait until it is done.
  void commit();

 private:
  struct Step {
    std::filesystem::path removed;
    std::optional<golden::PendingFile> written;
  };
  struct MadeFolder {
    explicit MadeFolder(const std::filesystem::path& folder);
    std::filesystem::path path;
    golden::RemovedOnSignal registered;
  };
  void remove_made() noexcept;

  std::filesystem::path directory_;
  std::list<MadeFolder> made_;  ///< the outermost first
  std::deque<Step> steps_;
};

}  // namespace ptm::testbench
