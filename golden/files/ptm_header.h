#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "golden/files/ptm_file.h"

namespace ptm::golden {

/// The text part of a .ptm, checked: docs/spec/ptm-file.md, section 2.
struct PtmHeader {
  PtmFileInfo info;  ///< all of it; header_bytes is the payload's first byte
  PtmMap map;        ///< all but the payload
};

/// The name after "PTM_FORMAT_" for a kind and a coding, e.g. "JPEG_LRGB"; empty where none exists.
[[nodiscard]] std::string format_name(MapKind kind, Coding coding);

/// The most bytes of a header: fifteen lines of at most 4,096.
inline constexpr std::size_t kMostHeaderBytes = std::size_t{1} << 16;

/// Reads the header. Throws InputError. The sizes it promises are not compared with the payload.
[[nodiscard]] PtmHeader parse_ptm_header(std::span<const std::uint8_t> bytes,
                                         const std::string& file);
/// The same from a file's first kMostHeaderBytes bytes, or all of fewer; it has `file_bytes`.
[[nodiscard]] PtmHeader parse_ptm_header(std::span<const std::uint8_t> head,
                                         const std::string& file, std::uint64_t file_bytes);

/// Reads a file's header, nothing more, and sees that the sizes it promises are the file's. Throws
/// InputError, also for a file or a map beyond the readers' limits (whole_file.h, plane_codec.h).
[[nodiscard]] PtmHeader read_ptm_header(const std::filesystem::path& path);

/// Writes the header for `map`, in the form that the strictest readers take: one number a line for
/// width and height, six a line for scales and biases, no blank before a line's end. The entries
/// of `info` that describe planes are written for coded formats only.
[[nodiscard]] std::string format_ptm_header(const PtmMap& map, const PtmFileInfo& info);

}  // namespace ptm::golden
