#pragma once
#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace ptm::tests {

/// A file system of the test's own, seen by this process and those it starts, and gone with them.
class SmallDisk {
 public:
  /// Where it cannot be mounted, mounted() says so.
  SmallDisk(std::filesystem::path where, const std::string& options) : path_(std::move(where)) {
    std::filesystem::create_directories(path_);
    own_mounts();
    mounted_ = mount("tmpfs", path_.c_str(), "tmpfs", 0, options.c_str()) == 0;
  }
  ~SmallDisk() {
    if (mounted_) umount2(path_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  [[nodiscard]] bool mounted() const { return mounted_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  void make_read_only() const {
    mount("tmpfs", path_.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr);
  }

 private:
  /// Once a process; where root's rights are missing, by a user namespace if the system lets us.
  static void own_mounts() {
    static const bool done = [] {
      const uid_t user = getuid();
      if (unshare(CLONE_NEWNS) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0) {
        std::ofstream("/proc/self/uid_map") << user << ' ' << user << " 1\n";
      }
      return mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
    }();
    (void)done;
  }

  std::filesystem::path path_;
  bool mounted_ = false;
};

}  // namespace ptm::tests
