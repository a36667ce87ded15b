#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "golden/files/input_error.h"

namespace ptm::golden {

/// Reads a file that must begin with `magic`; a file that does not is refused before the rest is
/// read. `what` names it in errors: "a .ptm file". Throws InputError.
[[nodiscard]] std::vector<std::uint8_t> read_whole_file(const std::filesystem::path& path,
                                                        std::string_view magic,
                                                        const std::string& what);

/// A file that is written under a temporary name beside its target and renamed when whole. Without
/// commit() nothing stays behind. The temporary name keeps the target's extension.
class PendingFile {
 public:
  /// Throws InputError where the target's folder is missing or the target is not a plain file.
  explicit PendingFile(std::filesystem::path target);
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile();

  [[nodiscard]] const std::filesystem::path& path() const { return temporary_; }
  /// Throws InputError.
  void write(std::span<const std::uint8_t> bytes) const;
  void commit();

 private:
  std::filesystem::path target_, temporary_;
};

}  // namespace ptm::golden
