#pragma once
#include <filesystem>
#include <memory>

namespace ptm::golden {

/// A folder in which this process keeps files or folders under temporary names,
///
///     .STEM.part-PROCESS-NUMBER.EXTENSION
///
/// as long as the claim stands. A program that is killed cannot remove them: the next one to claim
/// the folder does, at the beginning of its claim or the end, where no other process holds a claim.
/// Claims are shared locks (flock) of the folder; where a file system has no such locks, nothing is
/// removed.
class FolderClaim {
 public:
  /// All users within this process share one claim of a folder. Never throws for a folder that is
  /// missing or cannot be read: then nothing is claimed and nothing removed.
  [[nodiscard]] static std::shared_ptr<const FolderClaim> of(const std::filesystem::path& folder);

  explicit FolderClaim(std::filesystem::path folder);
  ~FolderClaim();
  FolderClaim(const FolderClaim&) = delete;
  FolderClaim& operator=(const FolderClaim&) = delete;

  /// A temporary name in the folder for a file that is to be called `name`, new at each call. The
  /// stem is cut where the whole would be longer than a file system takes.
  [[nodiscard]] std::filesystem::path temporary_name(const std::filesystem::path& name) const;

 private:
  void remove_leftovers() const;

  std::filesystem::path folder_;
  int lock_;  ///< -1: not claimed
};

}  // namespace ptm::golden
