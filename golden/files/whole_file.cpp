#include "golden/files/whole_file.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
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

}  // namespace

std::vector<std::uint8_t> read_whole_file(const std::filesystem::path& path, std::string_view magic,
                                          const std::string& what) {
  const std::string name = path.string();
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(name, "file", "a folder", what);
  const OpenFile file(std::fopen(name.c_str(), "rb"));
  if (file == nullptr) throw InputError(name, "file", reason(), what);
  std::vector<std::uint8_t> bytes(magic.size());
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
  const std::string_view head(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (head != magic) {
    throw InputError(name, "byte 0", head.empty() ? "an empty file" : quoted(head),
                     what + ", which begins with " + quoted(magic));
  }
  std::array<std::uint8_t, 65536> chunk{};
  while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
    bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(count));
  }
  if (std::ferror(file.get()) != 0) throw InputError(name, "file", reason(), what);
  return bytes;
}

PendingFile::PendingFile(std::filesystem::path target) : target_(std::move(target)) {
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
  name += ".part-" + std::to_string(getpid()) + "-" + std::to_string(serial++);
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
