// RTL units that are built when asked for: damaged libraries, folders and disks that cannot hold
// them, tools that fail, programs that are killed meanwhile, sources that are gone.
#include "tests/faults/variant_cache.h"

#include "tests/faults/started_program.h"

namespace ptm::tests {
namespace {

namespace fs = std::filesystem;

void put(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

TEST_F(VariantCache, BuildsDamagedLibrariesAgain) {
  replace_cmake_by_copy();
  const fs::path cache = file("cache");
  ASSERT_EQ(run_scene(cache, with_tools()).code, 0);
  const std::vector<std::string> names = names_in(cache);
  ASSERT_EQ(names.size(), 1U);
  const fs::path library = cache / names.front();
  const std::string whole = text_of(library);
  ASSERT_GT(whole.size(), 10000U);
  std::vector<std::string> damaged{"", whole.substr(0, whole.size() / 2), whole.substr(1),
                                   std::string(whole.size(), '\0'), whole + '\0'};
  for (const std::size_t at : {std::size_t{0}, whole.size() / 3, whole.size() - 1}) {
    damaged.push_back(whole);
    damaged.back()[at] = static_cast<char>(damaged.back()[at] ^ 4);
  }
  for (std::size_t n = 0; n < damaged.size(); ++n) {
    put(library, damaged[n]);
    const Outcome outcome = run_scene(cache, with_tools());
    EXPECT_EQ(outcome.code, 0) << n << ": " << outcome.err;
    EXPECT_NE(outcome.err.find("is damaged"), std::string::npos) << n << ": " << outcome.err;
    EXPECT_EQ(text_of(library), whole) << n;
    EXPECT_EQ(names_in(cache), names) << n;
  }
  EXPECT_EQ(run_scene(cache, "PATH=/nowhere").code, 0) << "a whole one needs no tool";
}

TEST_F(VariantCache, SaysWhichToolIsMissingOrFails) {
  const Outcome missing = run_scene(file("cache"), "PATH=/nowhere");
  EXPECT_EQ(missing.code, 4);
  EXPECT_NE(missing.err.find("install the package cmake"), std::string::npos) << missing.err;
  replace_cmake("echo no compiler here; exit 7", "");
  const Outcome fails = run_scene(file("cache"), with_tools());
  EXPECT_EQ(fails.code, 4);
  EXPECT_NE(fails.err.find("no compiler here"), std::string::npos) << fails.err;
  replace_cmake("", "kill -SEGV $$");
  EXPECT_EQ(run_scene(file("cache"), with_tools()).code, 4);
  EXPECT_TRUE(names_in(file("cache")).empty());
  EXPECT_FALSE(fs::exists(file("out")));
}

TEST_F(VariantCache, RefusesFoldersThatCannotHoldIt) {
  replace_cmake("", "exit 1");
  write("file", "in the way");
  fs::create_symlink("b", file("a"));
  fs::create_symlink("a", file("b"));
  for (const char* cache : {"file", "file/below", "a", "a/below"}) {
    const Outcome outcome = run_scene(file(cache), with_tools());
    EXPECT_EQ(outcome.code, 3) << cache;
    EXPECT_NE(outcome.err.find(file(cache).string() + ": $PTMSIM_CACHE: found "), std::string::npos)
        << outcome.err;
  }
  const SmallDisk disk(file("disk"), "");
  if (!disk.mounted()) GTEST_SKIP() << "a file system cannot be mounted here";
  disk.make_read_only();
  for (const fs::path& cache : {disk.path(), disk.path() / "below"}) {
    const Outcome outcome = run_scene(cache, with_tools());
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.err.find("Read-only file system"), std::string::npos) << outcome.err;
  }
}

TEST_F(VariantCache, TellsAFullDiskFromAToolThatFails) {
  const SmallDisk disk(file("disk"), "size=4m");
  if (!disk.mounted()) GTEST_SKIP() << "a file system cannot be mounted here";
  const auto expect_full = [&] {
    const Outcome outcome = run_scene(disk.path(), with_tools());
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.err.find("No space left on device"), std::string::npos) << outcome.err;
    EXPECT_TRUE(names_in(disk.path()).empty());
  };
  // One tool says why it stops and removes what it has written, one stops over half a file.
  const std::string fill = "dd if=/dev/zero of=\"$build/big\" bs=64k ";
  replace_cmake("", fill + "|| { rm \"$build/big\"; exit 1; }");
  expect_full();
  replace_cmake("", fill + "2>/dev/null; exit 1");
  expect_full();
  // The library fits and its digest does not: no library.
  replace_cmake("", "cat /dev/zero > \"$build/ptm_variant.so\" 2>/dev/null; exit 0");
  expect_full();
  std::ofstream(disk.path() / "zz", std::ios::binary) << std::string(4 << 20, 'z');
  EXPECT_EQ(run_scene(disk.path(), with_tools()).code, 3) << "not even the sources fit";
  EXPECT_EQ(names_in(disk.path()), std::vector<std::string>{"zz"});
}

TEST_F(VariantCache, EndsToolsWithTheProgramWhateverEndsIt) {
  // As ninja does, it starts processes in groups of their own, and those start others.
  const std::string tool =
      "setsid sh -c 'sleep 300 & sleep 300' & sleep 300 & touch \"$build/../started\"; wait";
  setenv("PTMSIM_CACHE", file("cache").c_str(), 1);
  setenv("PATH", (file("tools").string() + ":" + path_variable()).c_str(), 1);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGKILL}) {
    replace_cmake("", tool);
    const StartedProgram program(
        {"run", file("scene.toml").string(), "--out", file("out").string()}, file("log"));
    const auto started = [&] {
      for (const std::string& name : names_in(file("cache"))) {
        if (fs::exists(file("cache") / name / "started")) return true;
      }
      return false;
    };
    for (int wait = 0; wait < 5000 && !started(); ++wait) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ASSERT_TRUE(started()) << text_of(file("log"));
    program.send(signal);
    const int status = program.wait();
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal);
    EXPECT_EQ(StartedProgram::orphans(), 0) << "signal " << signal;
    EXPECT_EQ(names_in(file("cache")).empty(), signal != SIGKILL) << "signal " << signal;
  }
  replace_cmake("exit 1", "");
  EXPECT_EQ(run_scene(file("cache")).code, 4);
  EXPECT_TRUE(names_in(file("cache")).empty()) << "the next run removes what SIGKILL left";
}

TEST_F(VariantCache, NeedsNoSourcesWhereTheProgramWasBuilt) {
  replace_cmake_by_copy();
  fs::copy_file(PTM_PROGRAM, file("ptmsim"));
  const SmallDisk nothing(PTM_SOURCE_DIR, "");
  if (!nothing.mounted()) GTEST_SKIP() << "a file system cannot be mounted here";
  ASSERT_FALSE(fs::exists(fs::path(PTM_SOURCE_DIR) / "rtl"));
  const Outcome builds = run_scene(file("cache"), with_tools(), file("ptmsim"));
  EXPECT_EQ(builds.code, 0) << builds.err;
  const Outcome loads = run_scene(file("cache"), "PATH=/nowhere", file("ptmsim"));
  EXPECT_EQ(loads.code, 0) << loads.err;
}

}  // namespace
}  // namespace ptm::tests
