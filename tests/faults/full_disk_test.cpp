// A disk that is full at any point of a command's work: exit code 3, and nothing is left; or all is
// there.
#include "tests/faults/commands.h"
#include "tests/faults/small_disk.h"

namespace ptm::tests {
namespace {

class FullDisk : public Program, public testing::WithParamInterface<std::size_t> {
 protected:
  static constexpr int kSide = 96;
  WritingCommand command_ = writing_commands(file("in"), kSide)[GetParam()];

  /// Under a limit of the largest file, in the shell's units, for systems without a small disk.
  int run_limited(const std::string& prefix, const std::filesystem::path& out) const {
    const std::string line = prefix + quoted(PTM_PROGRAM) + " " +
                             shell_words(words_for(command_, out)) + " >/dev/null 2>" +
                             quoted(file("err"));
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// Of those that make their folder, a new one: it is not to stay either.
  std::filesystem::path out_on(const std::filesystem::path& disk) const {
    const bool makes = command_.name == "run" || command_.name == "synthesize";
    return makes ? disk / "made" / "for it" : disk;
  }

  /// True where the command could do its work.
  bool work_on(const SmallDisk& disk, int kib) const {
    const std::string limit =
        disk.mounted() ? "" : "ulimit -f " + std::to_string(kib / 4 + 1) + "; ";
    const std::filesystem::path out = out_on(disk.path());
    const int code = run_limited(limit, out);
    if (code == 0) {
      EXPECT_EQ(names_in(out), command_.files);
      return true;
    }
    EXPECT_EQ(code, 3) << text_of(file("err"));
    EXPECT_EQ(names_in(disk.path()), std::vector<std::string>{});
    // A limit of size may also meet what the models hand each other.
    EXPECT_EQ(text_of(file("err")).find(out.string()) == std::string::npos && disk.mounted(), false)
        << "which file? " << text_of(file("err"));
    return false;
  }
};

TEST_P(FullDisk, EndsTheCommandWithItsNameAndLeavesNothing) {
  constexpr int kLarge = 4096, kPage = 4;
  int needed = 0;
  {
    const SmallDisk disk(file("disk"), "size=" + std::to_string(kLarge) + "k");
    ASSERT_TRUE(work_on(disk, kLarge)) << "no disk was large enough";
    for (const std::string& name : command_.files) {
      const auto size = std::filesystem::file_size(out_on(disk.path()) / name);
      needed += static_cast<int>((size + 4095) / 4096) * kPage;
    }
  }
  std::filesystem::remove_all(file("disk"));
  // One page short, where all but the last file may fit. (Its length may vary: it holds durations.)
  for (const int kib : {kPage, needed - kPage}) {
    const SmallDisk disk(file("disk"), "size=" + std::to_string(std::max(kib, kPage)) + "k");
    const bool worked = work_on(disk, kib);
    EXPECT_FALSE(worked && kib == kPage && needed > kPage) << "the disk was not small enough";
  }
}

TEST_P(FullDisk, KeepsTheOldFilesOfAnEarlierRun) {
  const SmallDisk disk(file("disk"), "size=2m");
  if (!disk.mounted()) GTEST_SKIP() << "a file system cannot be mounted here";
  for (const std::string& name : command_.files) std::ofstream(disk.path() / name) << "old";
  // All the rest of the disk but a page.
  const std::uintmax_t space = std::filesystem::space(disk.path()).available;
  std::ofstream(disk.path() / "zz", std::ios::binary) << std::string(space - 4096, 'z');
  EXPECT_EQ(run_limited("", disk.path()), 3) << text_of(file("err"));
  std::vector<std::string> names = command_.files;
  names.emplace_back("zz");
  EXPECT_EQ(names_in(disk.path()), names);
  for (const std::string& name : command_.files) {
    EXPECT_EQ(text_of(disk.path() / name), "old") << name;
  }
}

std::string name_of(const testing::TestParamInfo<std::size_t>& index) {
  static const std::vector<std::string> names{"fit",         "render", "run",       "convert",
                                              "convert_mip", "bump",   "synthesize"};
  return names[index.param];
}

INSTANTIATE_TEST_SUITE_P(Commands, FullDisk, testing::Range<std::size_t>(0, 7), name_of);

class FullOutput : public Program, public testing::WithParamInterface<const char*> {};

TEST_P(FullOutput, OfAnyCommandIsExitCodeThree) {
  golden::write_ptm(file("map.ptm"), small_map(golden::MapKind::lrgb, 8, 8));
  write("scene.toml", flat_scene("map.ptm", "\"golden\"", 1));
  const std::string line = "cd " + quoted(file("")) + "; " + quoted(PTM_PROGRAM) + " " +
                           GetParam() + " >/dev/full 2>/dev/null";
  const int status = std::system(line.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 3);
}

INSTANTIATE_TEST_SUITE_P(Commands, FullOutput,
                         testing::Values("fit --help", "info map.ptm", "plan scene.toml",
                                         "vectors --count 3", "run scene.toml --out out",
                                         "convert map.ptm c.ptm --json",
                                         "synthesize --out s --size 16 --lights 1"));

}  // namespace
}  // namespace ptm::tests
