#include "golden/files/whole_file.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>

#include "golden/files/number_text.h"

namespace ptm::golden {
namespace {

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, FileCloser>;

/// errno as text; the caller has not called anything since the failure.
std::string reason() { return std::strerror(errno); }

[[noreturn]] void cannot_write(const std::filesystem::path& target, const std::string& found) {
  throw InputError(target.string(), "output", found, "a place where a file can be written");
}

/// Opens a plain file and nothing else; a pipe would block, a device might never end.
OpenFile open_plain_file(const std::filesystem::path& path, const std::string& what,
                         std::uintmax_t most_bytes) {
  require_plain_file(path, what);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > most_bytes) {
    throw InputError(path.string(), "size", std::to_string(size) + " bytes",
                     what + " of at most " + std::to_string(most_bytes) + " bytes");
  }
  OpenFile file(std::fopen(path.c_str(), "rb"));
  if (file == nullptr) throw InputError(path.string(), "file", reason(), what);
  return file;
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

/// What a symbolic link stands for, whether it exists or not: the link is to stay a link.
std::filesystem::path link_target(std::filesystem::path path) {
  std::error_code error;
  for (int links = 0; std::filesystem::is_symlink(path, error); ++links) {
    if (links == 40) cannot_write(path, "a loop of symbolic links");
    const std::filesystem::path to = std::filesystem::read_symlink(path, error);
    if (error) cannot_write(path, error.message());
    path = path.parent_path() / to;  // an absolute `to` replaces the folder
  }
  return path;
}

/// Removes what a program that was killed left of an earlier attempt to write the same file.
void remove_leftovers(const std::filesystem::path& folder, const std::string& begin) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(begin)) continue;
    const auto process = parse_integer(
        std::string_view(name).substr(begin.size(), name.find('-', begin.size()) - begin.size()),
        1, 1 << 30);
    const bool gone =
        process && kill(static_cast<pid_t>(*process), 0) != 0 && errno == ESRCH;
    std::error_code ignored;
    if (gone) std::filesystem::remove(entry.path(), ignored);
  }
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

std::vector<std::uint8_t> read_whole_file(const std::filesystem::path& path, std::string_view magic,
                                          const std::string& what, std::uintmax_t most_bytes) {
  const OpenFile file = open_plain_file(path, what, most_bytes);
  std::vector<std::uint8_t> bytes(magic.size());
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
  if (std::ferror(file.get()) != 0) throw InputError(path.string(), "file", reason(), what);
  const std::string_view head(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (head != magic) {
    throw InputError(path.string(), "byte 0", head.empty() ? "an empty file" : quoted(head),
                     what + ", which begins with " + quoted(magic));
  }
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

PendingFile::PendingFile(std::filesystem::path target) : target_(link_target(std::move(target))) {
  static std::atomic<unsigned> serial{0};
  std::error_code ignored;
  const std::filesystem::path folder = target_.has_parent_path() ? target_.parent_path() : ".";
  if (!std::filesystem::is_directory(folder, ignored)) {
    cannot_write(target_, "no folder " + folder.string());
  }
  // Renaming onto a device or a folder would replace it or fail late.
  if (std::filesystem::exists(target_, ignored) &&
      !std::filesystem::is_regular_file(target_, ignored)) {
    cannot_write(target_, "something that is not a plain file");
  }
  if (!target_.has_filename()) cannot_write(target_, "no file name");
  std::string name = ".";
  name += target_.stem().string();
  name += ".part-";
  remove_leftovers(folder, name);
  name += std::to_string(getpid()) + "-" + std::to_string(serial++);
  name += target_.extension().string();
  temporary_ = folder / name;
}

PendingFile::~PendingFile() {
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

void PendingFile::write(std::span<const std::uint8_t> bytes) const {
  OpenFile file(std::fopen(temporary_.c_str(), "wb"));
  if (file == nullptr) cannot_write(target_, reason());
  const bool whole = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  // The last bytes may meet a full disk only when they are flushed.
  if (!whole || std::fflush(file.get()) != 0) cannot_write(target_, reason());
}

void PendingFile::commit() {
  std::error_code error;
  std::filesystem::rename(temporary_, target_, error);
  if (error) cannot_write(target_, error.message());
  temporary_.clear();
}

}  // namespace ptm::golden
