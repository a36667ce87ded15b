#include "testbench/rtl/work_folder.h"

namespace ptm::testbench {

WorkFolder::WorkFolder(const std::filesystem::path& name)
    : claim_(golden::FolderClaim::of(name.parent_path())),
      path_(claim_->temporary_name(name.filename())) {
  std::filesystem::create_directory(path_);
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace ptm::testbench
