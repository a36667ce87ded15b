#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "golden/files/pending_file.h"

namespace ptm::golden {

/// Writes an 8-bit picture of 1 or 3 channels row by row, top row first, in the format of the
/// name's extension; it has its name after commit() only. Throws InputError where it cannot be
/// written.
class PictureRowWriter {
 public:
  PictureRowWriter(const std::filesystem::path& path, int width, int height, int channels = 1);
  ~PictureRowWriter();
  void write(std::span<const std::uint8_t> rows);
  /// As PendingFile's; no row may follow.
  void finish();
  void commit();

 private:
  struct Output;
  PendingFile file_;
  std::unique_ptr<Output> output_;
  std::size_t row_;  ///< samples of one
  int next_row_ = 0;
  bool finished_ = false;
};

}  // namespace ptm::golden
