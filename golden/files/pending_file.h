#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

#include "golden/files/ending_signals.h"
#include "golden/files/folder_claim.h"

namespace ptm::golden {

/// A file that is written under a temporary name beside its target and renamed when whole. Without
/// commit() nothing stays behind, whether the program ends by itself or by a signal. A target that
/// is a symbolic link stays one: what it stands for is written.
class PendingFile {
 public:
  /// Throws InputError where no file can be made beside the target, or where the target is there
  /// and not a plain file.
  explicit PendingFile(const std::filesystem::path& target);
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile();

  /// The temporary file. Its name keeps the target's extension.
  [[nodiscard]] const std::filesystem::path& path() const { return temporary_; }
  /// The whole file. Throws InputError.
  void write(std::span<const std::uint8_t> bytes);
  void write(std::string_view bytes);
  /// A part of it; parts may come in any order. Throws InputError.
  void write_at(std::uint64_t offset, std::span<const std::uint8_t> bytes);
  /// All was written. Throws InputError where the system tells only now that a disk is full. Of
  /// several files that belong together, finish each before the first is committed.
  void finish();
  void commit();

 private:
  std::filesystem::path target_;
  std::shared_ptr<const FolderClaim> claim_;
  std::filesystem::path temporary_;  ///< empty after commit()
  std::unique_ptr<RemovedOnSignal> registered_;
  int file_ = -1;  ///< open until finish()
};

}  // namespace ptm::golden
