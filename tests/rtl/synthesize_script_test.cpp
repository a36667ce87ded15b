// scripts/synthesize: cells, area, clock, and the netlist against the reference's vectors.
#include "tests/rtl/rtl_tools.h"
#include "tests/scratch_folder.h"

namespace ptm::tests {
namespace {

ToolRun synthesize(const std::string& arguments) {
  return run_tool("PTMSIM='" PTM_PROGRAM "' scripts/synthesize " + arguments);
}

/// The cells of the row of that name.
std::vector<std::string> row(const std::string& table, const std::string& name) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("| " + name + " |", 0) != 0) continue;
    std::vector<std::string> cells;
    std::istringstream text(line.substr(1));
    for (std::string cell; std::getline(text, cell, '|');) cells.push_back(cell.substr(1));
    return cells;
  }
  return {};
}

/// A narrow format, so that it takes seconds. Its registers are counted from the widths of
/// docs/spec/evaluator.md elsewhere; here that the figures are there and move the right way.
TEST(SynthesizeScript, MakesARowOfAnyFormatAndAWiderOneIsLarger) {
  const ScratchFolder folder;
  const std::string out = "--out '" + (folder / "out").string() + "' ";
  const ToolRun narrow = synthesize(out + "BasisFrac=4 LightFrac=4 Guard=0 LumBits=8");
  ASSERT_EQ(narrow.status, 0) << narrow.output;
  const ToolRun wide = synthesize(out + "BasisFrac=4 LightFrac=4 Guard=2 LumBits=8");
  ASSERT_EQ(wide.status, 0) << wide.output;
  const auto a = row(narrow.output, "changed"), b = row(wide.output, "changed");
  ASSERT_GE(a.size(), 8U) << narrow.output;
  ASSERT_GE(b.size(), 8U) << wide.output;
  EXPECT_GT(std::stod(a[1]), 1000) << "cells";
  EXPECT_GT(std::stod(b[3]), std::stod(a[3])) << "flip-flops";
  EXPECT_EQ(std::stod(a[4]), 0) << "memory bits";
  EXPECT_GT(std::stod(a[5]), 0.5) << "period";
  EXPECT_NEAR(std::stod(a[5]) * std::stod(a[6]), 1000, 10) << "period and clock";
}

TEST(SynthesizeScript, RefusesWhatIsNoParameterOrNoInteger) {
  const ToolRun unknown = synthesize("Gard=6");
  EXPECT_EQ(WEXITSTATUS(unknown.status), 2);
  EXPECT_NE(unknown.output.find("no parameter Gard"), std::string::npos) << unknown.output;
  const ToolRun word = synthesize("Guard=six");
  EXPECT_EQ(WEXITSTATUS(word.status), 2);
  EXPECT_NE(word.output.find("Guard=six"), std::string::npos) << word.output;
}

/// The bench itself: a planted fault in the RTL is told.
TEST(NetlistBench, TakesTheRtlInIverilogAndFindsAPlantedFault) {
  const ScratchFolder folder;
  const std::string vectors = (folder / "vectors.csv").string();
  ASSERT_EQ(
      run_tool("'" PTM_PROGRAM "' vectors --count 500 | tail -n +2 >'" + vectors + "'").status, 0);
  const auto verdict = [&](const std::string& sum) {
    std::string sources;
    for (const std::string& file : rtl_files()) {
      sources += ' ' + (file == "rtl/evaluator/ptm_evaluator_sum.sv" ? "'" + sum + "'" : file);
    }
    const std::string bench = (folder / "bench.vvp").string();
    const ToolRun run = run_tool("iverilog -g2012 -DYOSYS -Irtl -s ptm_netlist_tb -o '" + bench +
                                 "' testbench/sv/ptm_netlist_tb.sv" + sources + " && vvp -n '" +
                                 bench + "' '+vectors=" + vectors + "' | tail -n 1");
    EXPECT_EQ(run.status, 0) << run.output;
    return run.output;
  };
  EXPECT_EQ(verdict("rtl/evaluator/ptm_evaluator_sum.sv"), "PASS 500 vectors\n");
  std::ifstream file(std::string(PTM_SOURCE_DIR) + "/rtl/evaluator/ptm_evaluator_sum.sv");
  std::ostringstream text;
  text << file.rdbuf();
  std::string changed = text.str();
  const std::size_t at = changed.rfind(" + ");
  ASSERT_NE(at, std::string::npos);
  changed.replace(at, 3, " - ");
  EXPECT_EQ(verdict(folder.write("sum.sv", changed).string()).rfind("FAIL", 0), 0U);
}

}  // namespace
}  // namespace ptm::tests
