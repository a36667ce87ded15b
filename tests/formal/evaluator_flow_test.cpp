// The evaluator as a whole: what its registers stand between, and that a stage's move together.
#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "model/reference/eval_config.h"
#include "testbench/prove/solver.h"
#include "testbench/rtl/command.h"
#include "tests/formal/changed_rtl.h"

namespace ptm::testbench {
namespace {

/// Parameters of ptm_evaluator_flow.
struct Flow {
  int rgb_map, due, age, stall_from, stall_to;
};
constexpr Flow kLrgb{0, 11, 8, 31, 0}, kRgb{1, 11, 8, 31, 0};
/// Three cycles without a taker: two pixels wait in the FIFO, and the second is the one that is
/// looked at, so it has been in the tail; behind it all registers are full.
constexpr Flow kStalledLrgb{0, 13, 11, 9, 11}, kStalledRgb{1, 15, 9, 11, 13};
/// The pixel behind those two, whose first pass is assembled while the FIFO is full.
constexpr Flow kThirdRgb{1, 17, 8, 11, 14};

Answer ask(const reference::EvalConfig& config, const Flow& flow, std::vector<std::string> files) {
  files.emplace_back("rtl/formal/ptm_evaluator_steps.sv");
  files.emplace_back("rtl/formal/ptm_evaluator_flow.sv");
  Property property{"ptm_evaluator_flow",
                    {{"RgbMap", flow.rgb_map},
                     {"Due", flow.due},
                     {"Age", flow.age},
                     {"StallFrom", flow.stall_from},
                     {"StallTo", flow.stall_to}}};
  for (const auto& [name, value] : reference::rtl_parameters(config)) {
    property.parameters.emplace_back(name, value);
  }
  return prove_in_cycle(property, files, flow.due);
}

void expect_flow(const reference::Preset& preset, const Flow& flow) {
  const Answer answer = ask(preset.config, flow, rtl_sources("rtl/files.f"));
  EXPECT_EQ(answer.verdict, Verdict::holds);
  std::cout << preset.name << ": " << answer.seconds << " s\n";
}

class EvaluatorFlow : public testing::TestWithParam<reference::Preset> {};

TEST_P(EvaluatorFlow, MakesOfAnLrgbPixelWhatTheStepsMakeOfIt) { expect_flow(GetParam(), kLrgb); }
TEST_P(EvaluatorFlow, MakesOfAnRgbPixelWhatTheStepsMakeOfItsPasses) {
  expect_flow(GetParam(), kRgb);
}

INSTANTIATE_TEST_SUITE_P(Presets, EvaluatorFlow, testing::ValuesIn(reference::kPresets),
                         [](const auto& preset) { return std::string(preset.param.name); });

TEST(StalledEvaluatorFlow, MakesOfAWaitingPixelWhatTheStepsMakeOfIt) {
  expect_flow(reference::find_preset("paper8"), kStalledLrgb);
  expect_flow(reference::find_preset("paper8"), kStalledRgb);
  expect_flow(reference::find_preset("paper8"), kThirdRgb);
}

TEST(EvaluatorFlowIfChanged, FailsForAFieldThatTheTailLoses) {
  const tests::ChangedRtl colour("rtl/evaluator/ptm_evaluator.sv", "head_rgb_q      <= tail_rgb_q",
                                 "head_rgb_q      <= ~tail_rgb_q");
  EXPECT_EQ(ask(reference::kPaper8, kStalledLrgb, colour.files()).verdict, Verdict::fails);
  // Passes that come while the FIFO is full.
  const tests::ChangedRtl passes("rtl/evaluator/ptm_evaluator_assemble.sv",
                                 "if (valid_i && !last) begin",
                                 "if (valid_i && !last && ready_i) begin");
  EXPECT_EQ(ask(reference::kPaper8, kThirdRgb, passes.files()).verdict, Verdict::fails);
}

TEST(EvaluatorFlowIfChanged, FailsForAFieldOfAnotherBeat) {
  // Red's factor one stage late: wrong only where the beat behind has another colour.
  const tests::ChangedRtl changed("rtl/evaluator/ptm_evaluator.sv",
                                  ".lum_i(r5_lum_q), .rgb_i(r5_rgb_q)",
                                  ".lum_i(r5_lum_q), .rgb_i({r5_rgb_q[3*RgbW-1:RgbW], "
                                  "r4_rgb_q[RgbW-1:0]})");
  EXPECT_EQ(ask(reference::kPaper8, kLrgb, changed.files()).verdict, Verdict::fails);
}

TEST(EvaluatorFlowIfChanged, FailsForPassesThatAreAssembledInAnotherOrder) {
  const tests::ChangedRtl changed("rtl/evaluator/ptm_evaluator_assemble.sv",
                                  "{lum_i, lum1_q, lum0_q}", "{lum_i, lum0_q, lum1_q}");
  EXPECT_EQ(ask(reference::kPaper8, kRgb, changed.files()).verdict, Verdict::fails);
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

/// Who drives each net: the register (r1, ..., head, tail) whose output it is, a port, or a cell.
class Drivers {
 public:
  explicit Drivers(const nlohmann::json& module) : module_(module) {
    for (const auto& [name, net] : module.at("netnames").items()) {
      const std::size_t mark = name.find('_');
      if (!name.ends_with("_q") || mark == std::string::npos) continue;
      for (const auto& bit : net.at("bits")) {
        if (bit.is_number()) stage_[bit.get<int>()] = name.substr(0, mark);
      }
    }
    for (const auto& [name, port] : module.at("ports").items()) {
      if (port.at("direction") != "input") continue;
      for (const auto& bit : port.at("bits")) port_[bit.get<int>()] = name;
    }
    for (const auto& [name, cell] : module.at("cells").items()) {
      for (const auto& [pin, bits] : cell.at("connections").items()) {
        if (cell.at("port_directions").at(pin) != "output") continue;
        for (const auto& bit : bits) {
          if (bit.is_number()) driver_[bit.get<int>()] = &cell;
        }
      }
    }
  }

  struct Register {
    std::string type, enable;       ///< "$dffe, rising, enabled by 1", the enabling net
    std::set<std::string> sources;  ///< of D: registers and ports
    bool operator<(const Register& other) const {
      return std::tie(type, enable, sources) < std::tie(other.type, other.enable, other.sources);
    }
  };
  /// Of each stage, what kinds of registers it has.
  [[nodiscard]] std::map<std::string, std::set<Register>> registers() const {
    std::map<std::string, std::set<Register>> found;
    for (const auto& [name, cell] : module_.at("cells").items()) {
      if (!is_register(cell)) continue;
      const auto& pins = cell.at("connections");
      Register one{cell.at("type"), pins.contains("EN") ? pins.at("EN").dump() : "none", {}};
      for (const char* polarity : {"CLK_POLARITY", "EN_POLARITY"}) {
        const auto& parameters = cell.at("parameters");
        if (!parameters.contains(polarity)) continue;
        const auto value = parameters.at(polarity).get<std::string>();
        if (value.find('1') == std::string::npos) one.type += std::string(" not ") + polarity;
      }
      std::set<int> seen;
      for (const auto& bit : pins.at("D")) add_sources(bit, seen, one.sources);
      for (const auto& bit : pins.at("Q")) {
        const auto stage = stage_.find(bit.is_number() ? bit.get<int>() : -1);
        found[stage == stage_.end() ? "?" : stage->second].insert(one);
      }
    }
    return found;
  }

 private:
  static bool is_register(const nlohmann::json& cell) {
    const auto type = cell.at("type").get<std::string>();
    return type.starts_with("$") && !type.starts_with("$paramod") &&
           (type.find("ff") != std::string::npos || type.find("latch") != std::string::npos ||
            type.find("mem") != std::string::npos);
  }

  void add_sources(const nlohmann::json& bit, std::set<int>& seen,
                   std::set<std::string>& sources) const {
    if (!bit.is_number() || !seen.insert(bit.get<int>()).second) return;
    const int net = bit.get<int>();
    if (const auto port = port_.find(net); port != port_.end()) {
      sources.insert(port->second);
      return;
    }
    const auto driver = driver_.find(net);
    if (driver == driver_.end()) return;
    const nlohmann::json& cell = *driver->second;
    if (is_register(cell)) {
      const auto stage = stage_.find(net);
      sources.insert(stage == stage_.end() ? "?" : stage->second);
      return;
    }
    for (const auto& [pin, bits] : cell.at("connections").items()) {
      if (cell.at("port_directions").at(pin) != "input") continue;
      for (const auto& input : bits) add_sources(input, seen, sources);
    }
  }

  const nlohmann::json& module_;
  std::map<int, std::string> stage_, port_;
  std::map<int, const nlohmann::json*> driver_;
};

/// What is wrong with the registers of stages 1 to 7: nothing if all of a stage load together, what
/// its step makes of the stage before and of nothing else.
std::string wrong_registers(const nlohmann::json& module) {
  const auto registers = Drivers(module).registers();
  const auto& load = module.at("netnames").at("load").at("bits");  // [1:7]: bit 0 is stage 7
  std::string wrong;
  for (int stage = 1; stage <= 7; ++stage) {
    const auto enable =
        nlohmann::json::array({load.at(static_cast<std::size_t>(7 - stage))}).dump();
    const auto found = registers.find("r" + std::to_string(stage));
    if (found == registers.end()) return wrong + "stage " + std::to_string(stage) + " has none\n";
    for (const auto& one : found->second) {
      std::set<std::string> others = one.sources;
      if (stage == 1) {
        for (const char* port : {"coef_i", "bias_i", "shift_i", "rgb_i", "lu_i", "lv_i",
                                 "rgb_map_i", "channel_i", "sideband_i"}) {
          others.erase(port);
        }
      } else {
        others.erase("r" + std::to_string(stage - 1));
      }
      if (one.type == "$dffe" && one.enable == enable && others.empty()) continue;
      wrong += "stage " + std::to_string(stage) + ": " + one.type + ", enable " + one.enable +
               (others.empty() ? "" : ", also from " + *others.begin()) + "\n";
    }
  }
  for (const auto& [group, kinds] : registers) {
    if (group != "head" && group != "tail" && group[0] != 'r') wrong += "register " + group + "\n";
  }
  return wrong;
}

TEST(EvaluatorRegisters, OfAStageLoadTogetherAndFromTheStageBeforeAlone) {
  const nlohmann::json module = evaluator_cells(rtl_sources("rtl/files.f"));
  ASSERT_FALSE(module.is_null());
  EXPECT_EQ(wrong_registers(module), "");
}

TEST(EvaluatorRegisters, ThatDoOtherwiseAreFound) {
  const std::tuple<const char*, const char*, const char*> changes[] = {
      {"      r4_rgb_q <= r3_rgb_q;\n      r4_acc_q <= acc;\n    end",
       "      r4_acc_q <= acc;\n    end\n    if (load[5]) r4_rgb_q <= r3_rgb_q;", "stage 4"},
      {"r5_rgb_q           <= r4_rgb_q;", "r5_rgb_q <= load[6] ? r4_rgb_q : '0;", "stage 5"},
      {"      r4_rgb_q <= r3_rgb_q;\n      r4_acc_q <= acc;\n    end",
       "      r4_rgb_q <= r3_rgb_q;\n    end\n    if (!ready_i) r4_acc_q <= '0;\n"
       "    else if (load[4]) r4_acc_q <= acc;",
       "stage 4"},
      {"r3_t5_q  <= t5;", "r3_t5_q  <= t5 ^ TermW'(r1_d0_q[0]);", "stage 3"}};
  for (const auto& [from, to, stage] : changes) {
    const tests::ChangedRtl changed("rtl/evaluator/ptm_evaluator.sv", from, to);
    const std::string wrong = wrong_registers(evaluator_cells(changed.files()));
    EXPECT_NE(wrong.find(stage), std::string::npos) << to << wrong;
  }
}

}  // namespace
}  // namespace ptm::testbench
