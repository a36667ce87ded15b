// The real tools, where there are no sources but those within the program.
#include "tests/faults/variant_cache.h"

namespace ptm::tests {
namespace {

namespace fs = std::filesystem;

using SlowVariantCache = VariantCache;

TEST_F(SlowVariantCache, BuildsAUnitWithoutTheSources) {
  fs::copy_file(PTM_PROGRAM, file("ptmsim"));
  const SmallDisk nothing(PTM_SOURCE_DIR, "");
  if (!nothing.mounted()) GTEST_SKIP() << "a file system cannot be mounted here";
  ASSERT_FALSE(fs::exists(fs::path(PTM_SOURCE_DIR) / "rtl"));
  const Outcome outcome = run_scene(file("cache"), "", file("ptmsim"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(names_in(file("cache")).size(), 1U);
}

TEST_F(SlowVariantCache, FindsADiskTooSmallForTheRealTools) {
  for (const char* size : {"size=256k", "size=1200k", "size=2m"}) {
    const SmallDisk disk(file("disk"), size);
    if (!disk.mounted()) GTEST_SKIP() << "a file system cannot be mounted here";
    const Outcome outcome = run_scene(disk.path());
    EXPECT_EQ(outcome.code, 3) << size;
    EXPECT_NE(outcome.err.find("No space left on device"), std::string::npos) << outcome.err;
    EXPECT_TRUE(names_in(disk.path()).empty());
  }
}

}  // namespace
}  // namespace ptm::tests
