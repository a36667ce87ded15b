#pragma once
#include <filesystem>
#include <memory>

#include "golden/files/ending_signals.h"
#include "golden/files/folder_claim.h"

namespace ptm::testbench {

/// A folder under a temporary name (golden::FolderClaim) that is gone with its owner. Signals wait
/// as long as it stands: they end the programs that work in it (run_command), and then, when it is
/// removed, this one.
class WorkFolder {
 public:
  /// Beside `name`, which the temporary name begins with. Throws std::filesystem::filesystem_error.
  explicit WorkFolder(const std::filesystem::path& name);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  golden::HeldSignals held_;
  std::shared_ptr<const golden::FolderClaim> claim_;
  std::filesystem::path path_;
};

}  // namespace ptm::testbench
