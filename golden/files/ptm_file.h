#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "golden/files/input_error.h"
#include "golden/files/ptm_map.h"

namespace ptm::golden {

enum class Coding : std::uint8_t { raw, jpeg, jpegls };

/// What a file said beside its map.
struct PtmFileInfo {
  std::string version;  ///< "PTM_1.2" or "PTM_1.1"
  std::string format;   ///< "PTM_FORMAT_LRGB" and so on
  Coding coding = Coding::raw;
  std::uint64_t file_bytes = 0;
  std::uint64_t header_bytes = 0;
  /// Coded formats only, one entry a plane.
  int quality = 0;
  std::vector<int> transforms, order, references;
  std::vector<std::uint64_t> compressed_bytes, side_bytes;
  std::vector<std::string> notes;  ///< odd but harmless things met while reading
};

class PendingFile;

struct PtmFile {
  PtmMap map;
  PtmFileInfo info;
};

/// Reads a .ptm. Throws InputError; allocates nothing before the sizes agree with the file's.
[[nodiscard]] PtmFile read_ptm(const std::filesystem::path& path);
/// The same from memory; `name` stands for the file in errors.
[[nodiscard]] PtmFile parse_ptm(std::span<const std::uint8_t> bytes, const std::string& name);

struct PtmWriteOptions {
  Coding coding = Coding::raw;
  bool version_1_1 = false;  ///< interleaved LRGB; raw lrgb only
  int jpeg_quality = 95;
  /// JPEG only: list every byte that the codec changed as side information, so that the map read
  /// back is the map written. Off, the file is small and lossy.
  bool exact = true;
  /// JPEG only: a plane may build on the inverse of another (transform 1). HP's files do so, and
  /// relight refuses them. JPEG-LS, which no other program reads, always may.
  bool inversion = false;
  /// JPEG-LS only: how far each byte of a plane may be from the one written, 0..127.
  int near = 0;
};

/// Writes to a temporary name and renames. Returns what a user should know (notes, one a line).
std::vector<std::string> write_ptm(const std::filesystem::path& path, const PtmMap& map,
                                   const PtmWriteOptions& options = {});
/// The same, into a file that the caller commits.
std::vector<std::string> write_ptm(PendingFile& file, const PtmMap& map,
                                   const PtmWriteOptions& options = {});
/// The bytes that write_ptm writes.
[[nodiscard]] std::vector<std::uint8_t> format_ptm(const PtmMap& map,
                                                   const PtmWriteOptions& options = {});

}  // namespace ptm::golden
