// Verilator's lint over rtl/, every warning an error, for every preset and top module.
#include "tests/rtl/rtl_tools.h"

namespace ptm::reference {
namespace {

class RtlLint : public testing::TestWithParam<Preset> {};

std::string parameters(const EvalConfig& config) {
  std::string text;
  for (const NamedParameter& parameter : rtl_parameters(config)) {
    text += " -G" + std::string(parameter.name) + '=' + std::to_string(parameter.value);
  }
  return text;
}

TEST_P(RtlLint, TheEvaluatorIsClean) {
  const tests::ToolRun run = tests::run_tool(
      "verilator --lint-only -Wall -Irtl rtl/lint.vlt -f rtl/files.f --top-module ptm_evaluator" +
      parameters(GetParam().config));
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_EQ(run.output, "");
}

INSTANTIATE_TEST_SUITE_P(Presets, RtlLint, testing::ValuesIn(kPresets),
                         [](const auto& tested) { return std::string(tested.param.name); });

class RtlLintBack : public testing::TestWithParam<const char*> {};

TEST_P(RtlLintBack, TheUnitsBackIsClean) {
  const tests::ToolRun run = tests::run_tool(
      "verilator --lint-only -Wall -Irtl rtl/lint.vlt -f rtl/files.f -f rtl/unit.f --top-module "
      "ptm_back " +
      std::string(GetParam()));
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_EQ(run.output, "");
}

INSTANTIATE_TEST_SUITE_P(
    Builds, RtlLintBack,
    testing::Values("-GTmus=1 -GPaletteLrgbPorts=1 -GPaletteRgbPorts=2",
                    "-GTmus=2 -GPaletteLrgbPorts=2 -GPaletteRgbPorts=4 -GCoefBits=5 -GDeltaBits=6",
                    "-GTmus=3 -GCoefBits=12 -GDeltaBits=13 -GFilterFrac=4 -GRoundNearest=0"),
    [](const auto& tested) { return "Tmus" + std::to_string(tested.index + 1); });

TEST(RtlLintRegisters, TheUnitsRegistersAreClean) {
  const tests::ToolRun run = tests::run_tool(
      "verilator --lint-only -Wall -Irtl rtl/lint.vlt -f rtl/files.f -f rtl/unit.f "
      "--top-module ptm_registers");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_EQ(run.output, "");
}

TEST(RtlLintLerp, TheLerpIsClean) {
  const tests::ToolRun run = tests::run_tool(
      "verilator --lint-only -Wall -Irtl rtl/lint.vlt -f rtl/files.f --top-module ptm_arith_lerp");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_EQ(run.output, "");
}

TEST(RtlFileLists, NameEveryModuleOfTheFolderOnce) {
  std::vector<std::string> listed = tests::rtl_files();
  const std::vector<std::string> unit = tests::rtl_files("rtl/unit.f");
  listed.insert(listed.end(), unit.begin(), unit.end());
  std::sort(listed.begin(), listed.end());
  std::vector<std::string> present;
  const std::filesystem::path root = PTM_SOURCE_DIR;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "rtl")) {
    const std::string name = std::filesystem::relative(entry.path(), root).string();
    // Stages of effects are found by their names, and properties are read by proofs alone.
    if (name.starts_with("rtl/effects/") || name.starts_with("rtl/formal/")) continue;
    if (entry.path().extension() == ".sv") present.push_back(name);
  }
  std::sort(present.begin(), present.end());
  EXPECT_EQ(listed, present);
}

TEST(RtlFileLists, AreOfModulesNamedAfterTheirFolder) {
  const std::filesystem::path rtl = std::filesystem::path(PTM_SOURCE_DIR) / "rtl";
  int modules = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(rtl)) {
    const std::filesystem::path folder = entry.path().parent_path();
    if (entry.path().extension() != ".sv" || folder == rtl) continue;
    std::string part = folder.filename();
    if (part == "contract" || part == "formal") continue;  // named by what they hold, or prove
    if (part == "effects") part = "effect";
    const std::string name = entry.path().stem();
    EXPECT_TRUE(name == "ptm_" + part || name.starts_with("ptm_" + part + "_")) << entry.path();
    ++modules;
  }
  EXPECT_GT(modules, 50);
}

}  // namespace
}  // namespace ptm::reference
