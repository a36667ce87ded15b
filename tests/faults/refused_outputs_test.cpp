// Places where no output can be: each is exit code 3 with its name and the reason, at once.
#include <sys/stat.h>

#include "tests/faults/commands.h"
#include "tests/faults/small_disk.h"

namespace ptm::tests {
namespace {

namespace fs = std::filesystem;

class RefusedOutputs : public Program, public testing::WithParamInterface<std::size_t> {
 protected:
  WritingCommand command_ = writing_commands(file("in"), 16)[GetParam()];

  void expect_refused_there(const fs::path& out, const std::string& says) const {
    expect_refused(shell_words(words_for(command_, out)), says);
  }
  [[nodiscard]] bool makes_its_folder() const {
    return command_.name == "run" || command_.name == "synthesize";
  }
};

TEST_P(RefusedOutputs, FoldersThatAreFilesOrLoopsOfLinks) {
  write("file", "in the way");
  fs::create_symlink("b", file("a"));
  fs::create_symlink("a", file("b"));
  for (const char* out : {"file/below", "a"}) {
    expect_refused_there(file(out), file(out).string());
  }
  if (!makes_its_folder()) expect_refused_there(file("missing"), "missing");
}

TEST_P(RefusedOutputs, FoldersThatCannotBeWritten) {
  const SmallDisk disk(file("disk"), "");
  if (disk.mounted()) {
    disk.make_read_only();
  } else {
    if (getuid() == 0) GTEST_SKIP() << "root may write anywhere, and cannot mount here";
    fs::permissions(disk.path(), fs::perms::owner_read | fs::perms::owner_exec);
  }
  const std::string why = disk.mounted() ? "Read-only file system" : "Permission denied";
  expect_refused_there(disk.path(), why);
  if (makes_its_folder()) expect_refused_there(disk.path() / "below", why);
}

TEST_P(RefusedOutputs, NamesOfPipesAndFolders) {
  const fs::path out = file("out");
  fs::create_directories(out);
  const std::string &first = command_.files.front(), &last = command_.files.back();
  ASSERT_EQ(mkfifo((out / first).c_str(), 0600), 0);
  expect_refused_there(out, first);
  fs::remove(out / first);
  fs::create_directories(out / last);
  expect_refused_there(out, last);
}

std::string name_of(const testing::TestParamInfo<std::size_t>& index) {
  static const std::vector<std::string> names{"fit",         "render", "run",       "convert",
                                              "convert_mip", "bump",   "synthesize"};
  return names[index.param];
}

INSTANTIATE_TEST_SUITE_P(Commands, RefusedOutputs, testing::Range<std::size_t>(0, 7), name_of);

class RefusedWork : public Program {};

TEST_F(RefusedWork, DevicesAsOutputs) {
  golden::write_ptm(file("map.ptm"), small_map(golden::MapKind::lrgb, 8, 8));
  const std::string map = quoted(file("map.ptm"));
  expect_refused("convert " + map + " /dev/null", "/dev/null");
  expect_refused("convert " + map + " /dev/full", "/dev/full");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(RefusedWork, APhotographThatIsALoopOfLinks) {
  write_capture(file("capture.lp"), 16);
  fs::remove(file("light3.png"));
  fs::create_symlink("light3.png", file("light3.png"));
  expect_refused("fit " + quoted(file("capture.lp")) + " --out " + quoted(file("f.ptm")),
                 "light3.png");
}

TEST_F(RefusedWork, MoreThanTheMemoryHolds) {
  golden::write_ptm(file("map.ptm"), small_map(golden::MapKind::lrgb, 8, 8));
  const std::size_t before = count_files();
  // More than the libraries take, less than the picture does.
  const std::string line = "ulimit -v 1500000; " + quoted(PTM_PROGRAM) + " render " +
                           quoted(file("map.ptm")) + " --light 0,0 --size 16000x16000 --out " +
                           quoted(file("p.png")) + " 2>" + quoted(file("err"));
  const int status = std::system(line.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_NE(text_of(file("err")).find("memory"), std::string::npos) << text_of(file("err"));
  EXPECT_EQ(count_files(), before + 1) << "the error, and nothing else";
}

TEST_F(RefusedWork, IsNotThatOfAVeryWideMap) {
  golden::write_ptm(file("map.ptm"), small_map(golden::MapKind::lrgb, 65000, 1));
  const Outcome outcome =
      run("convert " + quoted(file("map.ptm")) + " " + quoted(file("m.ptm")) + " --mip");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(golden::read_ptm(file("m.1.ptm")).map.width, 32500);
  EXPECT_EQ(golden::read_ptm(file("m.15.ptm")).map.width, 1);
}

}  // namespace
}  // namespace ptm::tests
