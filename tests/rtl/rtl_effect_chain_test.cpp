// The chain of stages that cmake/EffectChain.cmake writes: the committed one, and one of another
// table.
#include "tests/rtl/rtl_tools.h"

namespace ptm::tests {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string chain_of(const std::string& table, const std::string& chain) {
  const ToolRun run = run_tool("cmake -D PTM_CHAIN_TABLE=" + table + " -D PTM_CHAIN=" + chain +
                               " -P cmake/EffectChain.cmake");
  EXPECT_EQ(run.status, 0) << run.output;
  return text_of(chain);
}

TEST(RtlEffectChain, ThatIsCommittedIsTheOneOfTheWholeTable) {
  const std::string chain = tests::scratch_file("effect_chain_of_all.sv");
  const std::string expected = chain_of("contract/effects.def", chain);
  EXPECT_NE(expected.find("ptm_effect_power"), std::string::npos);
  EXPECT_EQ(text_of(std::string(PTM_SOURCE_DIR) + "/rtl/effects/ptm_effect_chain.sv"), expected)
      << "write it with the command that stands in cmake/EffectChain.cmake";
  std::filesystem::remove(chain);
}

/// A made-up stage, and the table's without one: lint and Yosys take the unit as it is otherwise.
TEST(RtlEffectChain, OfAnotherTableNeedsNoChangeOfTheUnit) {
  const std::filesystem::path folder = tests::scratch_file("other_stages");
  std::filesystem::create_directory(folder);
  const std::string tint = (folder / "ptm_effect_tint.sv").string();
  std::string stage = text_of(std::string(PTM_SOURCE_DIR) + "/rtl/effects/ptm_effect_add.sv");
  stage.replace(stage.find("ptm_effect_add #"), 14, "ptm_effect_tint");
  std::ofstream(tint) << stage;
  std::ofstream(folder / "effects.def") << "PTM_STAGE(6, tint)\nPTM_STAGE(0, power)\n";
  const std::string chain = (folder / "ptm_effect_chain.sv").string();
  const std::string text = chain_of((folder / "effects.def").string(), chain);
  EXPECT_LT(text.find("u_power"), text.find("u_tint"));  // by number
  EXPECT_EQ(text.find("u_modulate"), std::string::npos);

  const ToolRun lint = run_tool("verilator --lint-only -Wall -Irtl -y " + folder.string() +
                                " -y rtl/effects rtl/lint.vlt -f rtl/files.f -f rtl/unit.f "
                                "--top-module ptm_unit -GExtraPasses=1 -GStages=65");
  EXPECT_EQ(lint.status, 0) << lint.output;
  EXPECT_EQ(lint.output, "");

  std::string files;
  for (const char* list : {"rtl/files.f", "rtl/unit.f"}) {
    for (const std::string& file : rtl_files(list)) files += ' ' + file;
  }
  const ToolRun yosys = run_tool(
      "yosys -q -p 'read_verilog -sv -Irtl" + files + ' ' + chain + ' ' + tint +
      " rtl/effects/ptm_effect_power.sv; chparam -set ExtraPasses 1 -set Stages 65 ptm_unit; "
      "hierarchy -check -top ptm_unit; select -assert-count 1 */t:*ptm_effect_tint*'");
  EXPECT_EQ(yosys.status, 0) << yosys.output;
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace ptm::tests
