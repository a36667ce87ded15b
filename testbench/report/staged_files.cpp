#include "testbench/report/staged_files.h"

#include <unistd.h>

#include <fstream>
#include <system_error>

#include "golden/files/input_error.h"

namespace ptm::testbench {

StagedFiles::StagedFiles(std::filesystem::path directory) : directory_(std::move(directory)) {
  std::error_code error;
  std::filesystem::create_directories(directory_, error);
  if (!std::filesystem::is_directory(directory_)) {
    throw golden::InputError(directory_.string(), "output directory",
                             error ? error.message() : "something else of that name",
                             "a directory that can be made and written");
  }
}

StagedFiles::~StagedFiles() {
  for (const Staged& file : staged_) {
    std::error_code ignored;  // nothing more can be done, and a destructor must not throw
    std::filesystem::remove(file.temporary, ignored);
  }
}

void StagedFiles::write(const std::string& name, std::string_view bytes) {
  const std::filesystem::path target = directory_ / name;
  std::filesystem::path temporary = target;
  temporary += ".tmp" + std::to_string(::getpid());
  staged_.push_back({temporary, target});
  std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) {
    throw golden::InputError(target.string(), "output", "an error while writing",
                             "a place that can be written");
  }
}

void StagedFiles::write(const std::string& name, std::span<const std::uint8_t> bytes) {
  write(name, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void StagedFiles::commit() {
  for (const Staged& file : staged_) {
    std::error_code error;
    std::filesystem::rename(file.temporary, file.target, error);
    if (error) {
      throw golden::InputError(file.target.string(), "output", error.message(),
                               "a name that can be replaced");
    }
  }
  staged_.clear();
}

}  // namespace ptm::testbench
