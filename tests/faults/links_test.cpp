// Outputs that are symbolic links: what a link stands for is written, and the link stays.
#include "tests/faults/commands.h"

namespace ptm::tests {
namespace {

namespace fs = std::filesystem;

class Links : public Program, public testing::WithParamInterface<std::size_t> {
 protected:
  WritingCommand command_ = writing_commands(file("in"), 48)[GetParam()];

  [[nodiscard]] Outcome write_into(const fs::path& out) const {
    return run(shell_words(words_for(command_, out)));
  }
};

TEST_P(Links, StayAndTheirTargetsAreWrittenWhetherTheyExistOrNot) {
  const fs::path out = file("out"), elsewhere = file("elsewhere");
  fs::create_directories(out);
  fs::create_directories(elsewhere);
  bool exists = false;
  for (const std::string& name : command_.files) {
    if (exists) std::ofstream(elsewhere / name) << "old";
    exists = !exists;
    fs::create_symlink(fs::path("..") / "elsewhere" / name, out / name);
  }
  const Outcome outcome = write_into(out);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(names_in(out), command_.files);
  EXPECT_EQ(names_in(elsewhere), command_.files);
  for (const std::string& name : command_.files) {
    EXPECT_TRUE(fs::is_symlink(out / name)) << name;
    EXPECT_GT(text_of(elsewhere / name).size(), 3U) << name;
  }
}

TEST_P(Links, InALoopAreRefusedAndNothingIsWritten) {
  // The last: what is written before it must not stay.
  const std::string& name = command_.files.back();
  const fs::path out = file("out");
  fs::create_directories(out);
  fs::create_symlink("other", out / name);
  fs::create_symlink(name, out / "other");
  const Outcome outcome = write_into(out);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("symbolic links"), std::string::npos) << outcome.err;
  EXPECT_EQ(names_in(out).size(), 2U);
}

TEST_P(Links, MayStandForTheOutputFolder) {
  fs::create_directories(file("folder"));
  fs::create_directory_symlink("folder", file("out"));
  EXPECT_EQ(write_into(file("out")).code, 0);
  EXPECT_EQ(names_in(file("folder")), command_.files);
}

std::string name_of(const testing::TestParamInfo<std::size_t>& index) {
  static const std::vector<std::string> names{"fit",         "render", "run",       "convert",
                                              "convert_mip", "bump",   "synthesize"};
  return names[index.param];
}

INSTANTIATE_TEST_SUITE_P(Commands, Links, testing::Range<std::size_t>(0, 7), name_of);

}  // namespace
}  // namespace ptm::tests
