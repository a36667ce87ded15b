#include "golden/files/folder_claim.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

namespace ptm::golden {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = ".part-";
constexpr std::string_view kDigits = "0123456789";

/// Whether the text begins with digits; takes them from it.
bool take_number(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_not_of(kDigits), text.size());
  text.remove_prefix(end);
  return end > 0;
}

bool is_temporary(std::string_view name) {
  const std::size_t mark = name.rfind(kMark);
  if (!name.starts_with('.') || mark == std::string_view::npos || mark == 0) return false;
  name.remove_prefix(mark + kMark.size());
  if (!take_number(name) || !name.starts_with('-')) return false;
  name.remove_prefix(1);
  return take_number(name) && (name.empty() || name.front() == '.');
}

void remove_temporaries(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    if (is_temporary(entry->path().filename().string())) fs::remove_all(entry->path(), ignored);
  }
}

}  // namespace

std::shared_ptr<const FolderClaim> FolderClaim::of(const fs::path& folder) {
  static std::mutex mutex;
  static std::map<fs::path, std::weak_ptr<const FolderClaim>> claims;
  std::error_code error;
  fs::path key =
      fs::canonical(folder, error);  // two claims of one folder would lock each other out
  if (error) key = folder;
  const std::lock_guard guard(mutex);
  std::weak_ptr<const FolderClaim>& known = claims[key];
  std::shared_ptr<const FolderClaim> claim = known.lock();
  if (!claim) known = claim = std::make_shared<const FolderClaim>(folder);
  return claim;
}

FolderClaim::FolderClaim(fs::path folder)
    : folder_(std::move(folder)), lock_(open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (lock_ < 0) return;
  // Alone, all temporary names here are of programs that have ended. Another program may claim the
  // folder before the lock is a shared one: it removes the same, and nothing of ours exists yet.
  remove_leftovers();
  flock(lock_, LOCK_SH);
}

FolderClaim::~FolderClaim() {
  if (lock_ < 0) return;
  remove_leftovers();  // of one that was still ending when this one came
  close(lock_);
}

void FolderClaim::remove_leftovers() const {
  if (flock(lock_, LOCK_EX | LOCK_NB) == 0) remove_temporaries(folder_);
}

fs::path FolderClaim::temporary_name(const fs::path& name) const {
  static std::atomic<unsigned> serial{0};
  std::string end(kMark);
  end += std::to_string(getpid()) + "-" + std::to_string(serial++);
  if (const std::string kind = name.extension().string(); kind.size() <= 16) end += kind;
  constexpr std::size_t kLongestName = 255;
  std::string temporary(1, '.');
  temporary += name.stem().string();
  temporary.resize(std::min(temporary.size(), kLongestName - end.size()));
  return folder_ / (temporary += end);
}

}  // namespace ptm::golden
