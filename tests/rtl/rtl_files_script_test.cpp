// scripts/rtl-files: a complete list that works from any folder and that the tools read.
#include "tests/rtl/rtl_tools.h"
#include "tests/scratch_folder.h"

namespace ptm::tests {
namespace {

class RtlFilesScript : public testing::Test {
 protected:
  /// In a folder that has nothing to do with the project's; the script is `$files`.
  ToolRun run(const std::string& command) const {
    return run_tool("files=$PWD/scripts/rtl-files && cd '" + (folder_ / "").string() + "' && (" +
                    command + ")");
  }
  ScratchFolder folder_;
};

TEST_F(RtlFilesScript, IsReadByVerilatorForBothTops) {
  for (const std::string top : {"evaluator", "unit"}) {
    const ToolRun lint = run("$files " + top + " --f >list && verilator --lint-only -Wall " +
                             "$(dirname $files)/../rtl/lint.vlt -f list --top-module ptm_" + top);
    EXPECT_EQ(lint.status, 0) << lint.output;
  }
}

TEST_F(RtlFilesScript, IsReadByYosysAndIcarus) {
  const ToolRun yosys =
      run("$files evaluator --yosys >list && yosys -q -s list -p 'hierarchy -check -top "
          "ptm_evaluator'");
  EXPECT_EQ(yosys.status, 0) << yosys.output;
  const ToolRun icarus =
      run("iverilog -g2012 -I$(dirname $files)/../rtl -o /dev/null -s ptm_evaluator $($files "
          "evaluator)");
  EXPECT_EQ(icarus.status, 0) << icarus.output;
}

/// A module that no list names would be found here and by nobody else.
TEST_F(RtlFilesScript, NamesEveryFileOnceAndTheTopLast) {
  const ToolRun list = run("$files unit");
  ASSERT_EQ(list.status, 0) << list.output;
  std::istringstream lines(list.output);
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);) {
    ASSERT_TRUE(std::filesystem::exists(line)) << line;
    names.push_back(std::filesystem::relative(line, PTM_SOURCE_DIR).string());
  }
  EXPECT_EQ(names.back(), "rtl/ptm_unit.sv");
  std::vector<std::string> there;
  const std::filesystem::path rtl = std::filesystem::path(PTM_SOURCE_DIR) / "rtl";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(rtl)) {
    if (entry.path().extension() != ".sv" || entry.path().parent_path() == rtl / "formal") continue;
    there.push_back(std::filesystem::relative(entry.path(), PTM_SOURCE_DIR).string());
  }
  std::sort(names.begin(), names.end());
  std::sort(there.begin(), there.end());
  EXPECT_EQ(names, there);
}

TEST_F(RtlFilesScript, RefusesOtherTops) {
  EXPECT_EQ(WEXITSTATUS(run("$files filter").status), 2);
  EXPECT_EQ(WEXITSTATUS(run("$files").status), 2);
  EXPECT_EQ(WEXITSTATUS(run("$files unit --ys").status), 2);
}

}  // namespace
}  // namespace ptm::tests
