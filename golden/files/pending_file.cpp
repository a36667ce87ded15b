#include "golden/files/pending_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "golden/files/input_error.h"

namespace ptm::golden {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write(const fs::path& target, const std::string& found) {
  throw InputError(target.string(), "output", found, "a place where a file can be written");
}

/// What a symbolic link stands for, whether it exists or not: the link is to stay a link.
fs::path link_target(fs::path path) {
  std::error_code error;
  for (int links = 0; fs::is_symlink(path, error); ++links) {
    if (links == 40) cannot_write(path, "a loop of symbolic links");
    const fs::path to = fs::read_symlink(path, error);
    if (error) cannot_write(path, error.message());
    path = path.parent_path() / to;  // an absolute `to` replaces the folder
  }
  return path;
}

/// Renaming onto a device or a folder would replace it or fail late.
void require_replaceable(const fs::path& target) {
  if (!target.has_filename()) cannot_write(target, "no file name");
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    cannot_write(target, "something that is not a plain file");
  }
  if (!fs::status_known(status)) cannot_write(target, error.message());
}

}  // namespace

PendingFile::PendingFile(const fs::path& target) : target_(link_target(target)) {
  require_replaceable(target_);
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : ".";
  std::error_code error;
  if (!fs::is_directory(folder, error)) cannot_write(target_, "no folder " + folder.string());
  claim_ = FolderClaim::of(folder);
  do {
    temporary_ = claim_->temporary_name(target_.filename());
    registered_ = std::make_unique<RemovedOnSignal>(temporary_);
    file_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (file_ < 0 && errno == EEXIST);  // of a process of the same number, on another machine
  if (file_ < 0) cannot_write(target_, std::strerror(errno));
}

PendingFile::~PendingFile() {
  if (file_ >= 0) close(file_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void PendingFile::write(std::span<const std::uint8_t> bytes) {
  write_at(0, bytes);
  finish();
}

void PendingFile::write(std::string_view bytes) {
  write({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

void PendingFile::write_at(std::uint64_t offset, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) cannot_write(target_, count == 0 ? "no room" : std::strerror(errno));
    bytes = bytes.subspan(static_cast<std::size_t>(count));
    offset += static_cast<std::uint64_t>(count);
  }
}

void PendingFile::finish() {
  const int file = std::exchange(file_, -1);
  if (file >= 0 && close(file) != 0) cannot_write(target_, std::strerror(errno));
}

void PendingFile::commit() {
  finish();
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) cannot_write(target_, error.message());
  temporary_.clear();
}

}  // namespace ptm::golden
