#pragma once
#include <cstdint>
#include <filesystem>
#include <span>

#include "golden/files/pending_file.h"
#include "golden/files/ptm_map.h"

namespace ptm::golden {

/// Writes an uncompressed .ptm some rows at a time, so that a large map need never be in memory.
/// Rows may come in any order, each once. The file has its name after commit() only, and the bytes
/// that write_ptm() writes.
class PtmRowWriter {
 public:
  /// `shape` is the map without coefficients and colours. Throws InputError.
  PtmRowWriter(const std::filesystem::path& path, const PtmMap& shape);
  /// Row 0 is the top; layouts as in PtmMap. Throws InputError.
  void write(int first_row, int rows, std::span<const std::uint8_t> coef,
             std::span<const std::uint8_t> color);
  /// As PendingFile's.
  void finish() { file_.finish(); }
  void commit() { file_.commit(); }

 private:
  PtmMap shape_;
  PendingFile file_;
  std::uint64_t header_bytes_ = 0;
};

}  // namespace ptm::golden
