#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "golden/files/input_error.h"

namespace ptm::golden {

enum class FileType : std::uint8_t {
  unknown,
  map,              ///< .ptm
  picture,          ///< of a format that the project reads
  scene,            ///< TOML with a scene's tables
  light_positions,  ///< .lp
  mesh,             ///< Wavefront OBJ
  other             ///< known by name only: nothing here reads it
};

/// What a file is, by its first bytes; by its name only where a format has no mark of its own.
struct FileKind {
  FileType type = FileType::unknown;
  std::string name;  ///< "a picture (PNG)"; "a file that begins with ..." of an unknown kind
  /// Pictures: OpenImageIO's name of the format. Empty for a camera's raw picture, whose first
  /// bytes may be TIFF's: there the extension tells more than the bytes.
  std::string format;
  /// Pictures of formats whose decoder takes memory for what the header says before anybody can
  /// ask for it (GIF, JPEG 2000, WebP): width and height as the header says.
  std::optional<std::pair<std::int64_t, std::int64_t>> size;
};

/// How many first bytes file_kind() asks for. Fewer are fine if the file has no more.
inline constexpr std::size_t kKindBytes = 4096;

[[nodiscard]] FileKind file_kind(std::span<const std::uint8_t> head,
                                 const std::filesystem::path& path);

/// The same of a file, whose first bytes alone are read. Throws InputError as require_plain_file()
/// does, and where reading fails; `what` names the expected kind.
[[nodiscard]] FileKind read_file_kind(const std::filesystem::path& path, const std::string& what);

/// The names of the formats of pictures that are read, for messages.
[[nodiscard]] std::string picture_formats();

}  // namespace ptm::golden
