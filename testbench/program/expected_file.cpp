#include "testbench/program/expected_file.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "golden/files/encoded_picture.h"

namespace ptm::testbench {
namespace {

using golden::FileType;

const char* name_of(FileType type) {
  switch (type) {
    case FileType::map:
      return "a .ptm file";
    case FileType::scene:
      return "a scene (TOML)";
    case FileType::light_positions:
      return "light positions (.lp), a table of lights, or a folder of photographs";
    case FileType::picture:
      return "a picture";
    default:
      return "another file";
  }
}

/// What to do with a file of that type.
const char* advice(FileType type) {
  switch (type) {
    case FileType::map:
      return "`ptmsim info`, `render` and `convert` take a .ptm, and `run` a scene whose [map] "
             "names it";
    case FileType::scene:
      return "`ptmsim run` and `plan` take a scene";
    case FileType::light_positions:
      return "`ptmsim fit` takes light positions and their photographs";
    case FileType::picture:
      return "`ptmsim bump` takes a picture of heights or normals, and `fit` a list of photographs";
    case FileType::mesh:
      return "a scene's [[object]] of kind \"mesh\" takes a mesh";
    default:
      return "this program reads polynomial texture maps (.ptm) only";
  }
}

[[noreturn]] void refuse(const std::filesystem::path& path, const golden::FileKind& kind,
                         const std::string& wanted) {
  throw golden::InputError(path.string(), "byte 0", kind.name, wanted + "; " + advice(kind.type));
}

}  // namespace

void expect_file(const std::filesystem::path& path, FileType wanted) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return;
  const golden::FileKind kind = golden::read_file_kind(path, name_of(wanted));
  if (kind.type != FileType::unknown && kind.type != wanted) refuse(path, kind, name_of(wanted));
}

FileType expect_map_or_picture(const std::filesystem::path& path) {
  const golden::FileKind kind = golden::read_file_kind(path, "a .ptm file or a picture");
  if (kind.type == FileType::map || kind.type == FileType::picture) return kind.type;
  // A map that lost its beginning is still a map to the reader's message.
  if (path.extension() == ".ptm" && kind.type == FileType::unknown) return FileType::map;
  if (kind.type == FileType::unknown) {
    throw golden::InputError(path.string(), "file", kind.name,
                             "a .ptm file, or a picture: " + golden::picture_formats());
  }
  refuse(path, kind, "a .ptm file or a picture");
}

void expect_map_name(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 3> others{".toml", ".lp", ".obj"};
  const std::string extension = path.extension().string();
  const bool other = std::find(others.begin(), others.end(), extension) != others.end();
  if (!other && !golden::is_picture_extension(path)) return;
  throw golden::InputError(path.string(), "output", "a name that ends in " + extension,
                           "one that ends in .ptm, since a map is written; `ptmsim render` makes "
                           "a picture of a map");
}

}  // namespace ptm::testbench
