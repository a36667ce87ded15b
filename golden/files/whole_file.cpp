#include "golden/files/whole_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>

#include "golden/files/figure_text.h"
#include "golden/files/file_kind.h"
#include "golden/files/number_text.h"

namespace ptm::golden {
namespace {

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, FileCloser>;

/// errno as text; the caller has not called anything since the failure.
std::string reason() { return std::strerror(errno); }

/// Opens a plain file and nothing else; a pipe would block, a device might never end.
OpenFile open_plain_file(const std::filesystem::path& path, const std::string& what,
                         std::uintmax_t most_bytes) {
  require_plain_file(path, what);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > most_bytes) {
    throw InputError(path.string(), "size", count_of(size, "byte"),
                     what + " of at most " + std::to_string(most_bytes) + " bytes");
  }
  OpenFile file(std::fopen(path.c_str(), "rb"));
  if (file == nullptr) throw InputError(path.string(), "file", reason(), what);
  return file;
}

/// As many of the file's first bytes as it has, at most `count`. Fewer because reading failed is an
/// error.
std::vector<std::uint8_t> first_bytes(std::FILE* file, const std::filesystem::path& path,
                                      const std::string& what, std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file));
  if (std::ferror(file) != 0) throw InputError(path.string(), "file", reason(), what);
  return bytes;
}

void check_magic(std::span<const std::uint8_t> head, const std::filesystem::path& path,
                 const std::string& what, std::string_view magic) {
  const std::string_view begin(reinterpret_cast<const char*>(head.data()), head.size());
  if (begin.starts_with(magic)) return;
  const FileKind kind = file_kind(head, path);
  const bool known = kind.type != FileType::unknown || head.empty();
  throw InputError(path.string(), "byte 0",
                   known ? kind.name : quoted(begin.substr(0, magic.size())),
                   what + ", which begins with " + quoted(magic));
}

/// Appends the rest of the file. A read that fails is an error, not the file's end.
template <class Bytes>
void append_rest(std::FILE* file, const std::filesystem::path& path, const std::string& what,
                 std::uintmax_t most_bytes, Bytes& bytes) {
  std::array<char, 65536> chunk{};
  while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file)) {
    bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(count));
    if (bytes.size() > most_bytes) {  // it grew since its size was asked for
      throw InputError(path.string(), "size", "more than " + std::to_string(most_bytes) + " bytes",
                       what + " of at most that many");
    }
  }
  if (std::ferror(file) != 0) throw InputError(path.string(), "file", reason(), what);
}

}  // namespace

void require_plain_file(const std::filesystem::path& path, const std::string& what) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  const auto fail = [&](const std::string& found) {
    throw InputError(path.string(), "file", found, what);
  };
  switch (status.type()) {
    case fs::file_type::regular:
      return;
    case fs::file_type::directory:
      return fail("a folder");
    case fs::file_type::fifo:
      return fail("a pipe, which can be read only once");
    case fs::file_type::character:
    case fs::file_type::block:
      return fail("a device");
    case fs::file_type::socket:
      return fail("a socket");
    default:
      return fail(error ? error.message() : "No such file or directory");
  }
}

std::vector<std::uint8_t> read_file_head(const std::filesystem::path& path, const std::string& what,
                                         std::string_view magic, std::size_t count,
                                         std::uintmax_t most_bytes) {
  const OpenFile file = open_plain_file(path, what, most_bytes);
  std::vector<std::uint8_t> bytes = first_bytes(file.get(), path, what, count);
  check_magic(bytes, path, what, magic);
  return bytes;
}

std::vector<std::uint8_t> read_whole_file(const std::filesystem::path& path, std::string_view magic,
                                          const std::string& what, std::uintmax_t most_bytes) {
  const OpenFile file = open_plain_file(path, what, most_bytes);
  std::vector<std::uint8_t> bytes = first_bytes(file.get(), path, what, kKindBytes);
  check_magic(bytes, path, what, magic);
  append_rest(file.get(), path, what, most_bytes, bytes);
  return bytes;
}

std::string read_text_file(const std::filesystem::path& path, const std::string& what,
                           std::uintmax_t most_bytes) {
  const OpenFile file = open_plain_file(path, what, most_bytes);
  std::string text;
  append_rest(file.get(), path, what, most_bytes, text);
  return text;
}

}  // namespace ptm::golden
