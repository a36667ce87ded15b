#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace ptm::tests {

/// Real input that is not ours to copy lies beside the checkout, in ../shared/data
/// (or where PTM_SHARED_DATA says). Tests that need it skip where it is absent.
inline std::filesystem::path shared_data() {
  if (const char* dir = std::getenv("PTM_SHARED_DATA")) return dir;
  return std::filesystem::path(PTM_SOURCE_DIR) / ".." / "shared" / "data";
}

}  // namespace ptm::tests

/// Sets `variable` to the path of a file or folder of the shared data, or skips the test.
#define PTM_SHARED_DATA_OR_SKIP(variable, relative)                            \
  const std::filesystem::path variable = ptm::tests::shared_data() / relative; \
  if (!std::filesystem::exists(variable)) GTEST_SKIP() << "absent: " << variable
