// The evaluator as a whole: what its registers stand between, and that a stage's move together.
#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

#include "model/reference/eval_config.h"
#include "testbench/prove/solver.h"
#include "testbench/rtl/command.h"
#include "tests/formal/changed_rtl.h"

namespace ptm::testbench {
namespace {

constexpr int kDue = 11;  ///< the cycle of ptm_evaluator_flow in which the pixel is due

Answer ask(const reference::EvalConfig& config, int rgb_map, std::vector<std::string> files) {
  files.emplace_back("rtl/formal/ptm_evaluator_steps.sv");
  files.emplace_back("rtl/formal/ptm_evaluator_flow.sv");
  Property property{"ptm_evaluator_flow", {{"RgbMap", rgb_map}}};
  for (const auto& [name, value] : reference::rtl_parameters(config)) {
    property.parameters.emplace_back(name, value);
  }
  return prove_in_cycle(property, files, kDue);
}

void expect_flow(const reference::Preset& preset, int rgb_map) {
  const Answer answer = ask(preset.config, rgb_map, rtl_sources("rtl/files.f"));
  EXPECT_EQ(answer.verdict, Verdict::holds);
  std::cout << preset.name << (rgb_map != 0 ? " RGB: " : " LRGB: ") << answer.seconds << " s\n";
}

class EvaluatorFlow : public testing::TestWithParam<reference::Preset> {};

TEST_P(EvaluatorFlow, MakesOfAnLrgbPixelWhatTheStepsMakeOfIt) { expect_flow(GetParam(), 0); }
TEST_P(EvaluatorFlow, MakesOfAnRgbPixelWhatTheStepsMakeOfItsPasses) { expect_flow(GetParam(), 1); }

INSTANTIATE_TEST_SUITE_P(Presets, EvaluatorFlow, testing::ValuesIn(reference::kPresets),
                         [](const auto& preset) { return std::string(preset.param.name); });

TEST(EvaluatorFlowIfChanged, FailsForAFieldOfAnotherBeat) {
  // Red's factor one stage late: wrong only where the beat behind has another colour.
  const tests::ChangedRtl changed("rtl/ptm_evaluator.sv", ".lum_i(r5_lum_q), .rgb_i(r5_rgb_q)",
                                  ".lum_i(r5_lum_q), .rgb_i({r5_rgb_q[3*RgbW-1:RgbW], "
                                  "r4_rgb_q[RgbW-1:0]})");
  EXPECT_EQ(ask(reference::kPaper8, 0, changed.files()).verdict, Verdict::fails);
}

TEST(EvaluatorFlowIfChanged, FailsForPassesThatAreAssembledInAnotherOrder) {
  const tests::ChangedRtl changed("rtl/ptm_rgb_assemble.sv", "{lum_i, lum1_q, lum0_q}",
                                  "{lum_i, lum0_q, lum1_q}");
  EXPECT_EQ(ask(reference::kPaper8, 1, changed.files()).verdict, Verdict::fails);
}

/// The evaluator's module, its own registers as cells with an enable, as Yosys sees it.
nlohmann::json evaluator_cells(const std::vector<std::string>& files) {
  const tests::ScratchFolder folder;
  const auto json = folder / "evaluator.json";
  const std::string script = read_verilog(files) +
                             "; hierarchy -check -top ptm_evaluator; proc; opt_expr; opt_dff "
                             "-simple-dffe; opt_clean; write_json " +
                             json.string();
  if (run_command({"yosys", "-p", script}, folder / "log", PTM_SOURCE_DIR) != 0) return {};
  const nlohmann::json design = nlohmann::json::parse(std::ifstream(json));
  return design.at("modules").value("ptm_evaluator", nlohmann::json());
}

/// For each group of registers (r1, ..., head, tail) the enables of its fields.
std::map<std::string, std::set<std::string>> enables_of(const nlohmann::json& module) {
  std::map<int, std::string> owner;  // net to the register whose output it is
  for (const auto& [name, net] : module.at("netnames").items()) {
    const std::size_t mark = name.find('_');
    if (!name.ends_with("_q") || mark == std::string::npos) continue;
    for (const auto& bit : net.at("bits")) {
      if (bit.is_number()) owner[bit.get<int>()] = name.substr(0, mark);
    }
  }
  std::map<std::string, std::set<std::string>> enables;
  for (const auto& [name, cell] : module.at("cells").items()) {
    const auto type = cell.at("type").get<std::string>();
    if (type.find("dff") == std::string::npos) continue;
    const auto& connections = cell.at("connections");
    const std::string enable =
        connections.contains("EN") ? connections.at("EN").dump() : "every cycle";
    for (const auto& bit : connections.at("Q")) {
      enables[bit.is_number() ? owner[bit.get<int>()] : "?"].insert(enable);
    }
  }
  return enables;
}

TEST(EvaluatorRegisters, OfAStageMoveTogetherWhenItsLoadSaysSo) {
  const nlohmann::json module = evaluator_cells(rtl_sources("rtl/files.f"));
  ASSERT_FALSE(module.is_null());
  const auto enables = enables_of(module);
  const auto& load = module.at("netnames").at("load").at("bits");  // [1:7]: bit 0 is stage 7
  ASSERT_EQ(load.size(), 7U);
  for (int stage = 1; stage <= 7; ++stage) {
    const std::set<std::string> expected{
        nlohmann::json::array({load.at(static_cast<std::size_t>(7 - stage))}).dump()};
    EXPECT_EQ(enables.at("r" + std::to_string(stage)), expected) << stage;
  }
  EXPECT_EQ(enables.at("head").size(), 1U);
  EXPECT_EQ(enables.at("tail").size(), 1U);
  EXPECT_EQ(enables.size(), 9U);  // and no other register
}

TEST(EvaluatorRegisters, ThatMoveOnAnothersLoadAreFound) {
  const tests::ChangedRtl changed("rtl/ptm_evaluator.sv",
                                  "      r4_rgb_q <= r3_rgb_q;\n      r4_acc_q <= acc;\n    end",
                                  "      r4_acc_q <= acc;\n    end\n"
                                  "    if (load[5]) r4_rgb_q <= r3_rgb_q;");
  const auto enables = enables_of(evaluator_cells(changed.files()));
  EXPECT_EQ(enables.at("r4").size(), 2U);
}

}  // namespace
}  // namespace ptm::testbench
