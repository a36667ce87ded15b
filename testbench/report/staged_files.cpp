#include "testbench/report/staged_files.h"

#include <system_error>
#include <vector>

#include "golden/files/input_error.h"

namespace ptm::testbench {
namespace {

namespace fs = std::filesystem;

/// The folders of a path that are not there, the outermost first.
std::vector<fs::path> missing_folders(const fs::path& path) {
  std::vector<fs::path> missing;
  fs::path above;
  for (const fs::path& part : path) {
    above /= part;
    std::error_code error;
    const bool absent = fs::status(above, error).type() == fs::file_type::not_found;
    if (absent && part != "." && !part.empty()) missing.push_back(above);
  }
  return missing;
}

}  // namespace

StagedFiles::MadeFolder::MadeFolder(const fs::path& folder)
    : path(folder), registered(folder, true) {}

StagedFiles::StagedFiles(fs::path directory) : directory_(std::move(directory)) {
  std::error_code error;
  for (const fs::path& folder : missing_folders(directory_)) {
    made_.emplace_back(folder);
    if (!fs::create_directory(folder, error)) made_.pop_back();
    if (error) break;
  }
  std::error_code unknown;
  if (!fs::is_directory(directory_, unknown)) {
    remove_made();
    const std::error_code why = error ? error : unknown;
    throw golden::InputError(directory_.string(), "output directory",
                             why ? why.message() : "something else of that name",
                             "a directory that can be made and written");
  }
}

StagedFiles::~StagedFiles() {
  steps_.clear();  // with the temporary files
  remove_made();
}

void StagedFiles::remove_made() noexcept {
  while (!made_.empty()) {
    std::error_code ignored;  // nothing more can be done, and others may have put files there
    fs::remove(made_.back().path, ignored);
    made_.pop_back();
  }
}

void StagedFiles::write(const std::string& name, std::string_view bytes) {
  steps_.emplace_back().written.emplace(directory_ / name).write(bytes);
}

void StagedFiles::write(const std::string& name, std::span<const std::uint8_t> bytes) {
  write(name, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void StagedFiles::remove(const std::string& name) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(directory_ / name, error).type();
  const bool file = type == fs::file_type::regular || type == fs::file_type::symlink;
  if (file) steps_.emplace_back().removed = directory_ / name;
}

void StagedFiles::commit() {
  const golden::HeldSignals held;
  for (Step& step : steps_) {
    if (step.written) {
      step.written->commit();
      continue;
    }
    std::error_code error;
    fs::remove(step.removed, error);
    if (error) {
      throw golden::InputError(step.removed.string(), "output", error.message(),
                               "an old file that can be removed");
    }
  }
  steps_.clear();
  made_.clear();
}

}  // namespace ptm::testbench
