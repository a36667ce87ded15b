// The operators in the RTL as Yosys sees them, by the rule of docs/spec/evaluator.md,
// "Operators": after `hierarchy; proc; opt_clean`, not flattened, counted times instances.
#include <array>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/rtl/rtl_tools.h"

namespace ptm::reference {
namespace {

using Counts = std::map<std::string, int>;           ///< operator -> how many
using ModuleCounts = std::map<std::string, Counts>;  ///< module, without parameters -> its own

/// "$paramod$<hash>\ptm_evaluator_sum" and "$paramod\ptm_evaluator_sum\TermW=..." are
/// ptm_evaluator_sum.
std::string base_name(const std::string& module) {
  const std::size_t begin = module.find("ptm_");
  if (begin == std::string::npos) return module;
  return module.substr(begin, module.find('\\', begin) - begin);
}

void add_instances(const nlohmann::json& modules, const std::string& module, ModuleCounts& counts) {
  Counts& own = counts[base_name(module)];
  for (const auto& [name, cell] : modules.at(module).at("cells").items()) {
    const auto type = cell.at("type").get<std::string>();
    if (modules.contains(type)) {
      add_instances(modules, type, counts);
    } else {
      ++own[type];
    }
  }
}

std::string read_all(const std::vector<std::string>& lists = {"rtl/files.f"}) {
  std::string script = "read_verilog -sv -Irtl";
  for (const std::string& list : lists) {
    for (const std::string& file : tests::rtl_files(list)) script += ' ' + file;
  }
  return script;
}

/// "; hierarchy ..." to the file of counts.
std::string write_top(const std::string& top, const std::string& json) {
  return "; hierarchy -top " + top + "; proc; opt_clean; write_json " + json;
}

std::string yosys_script(const EvalConfig& config, const std::string& json) {
  std::string script = read_all() + "; chparam";
  for (const NamedParameter& parameter : rtl_parameters(config)) {
    script += " -set " + std::string(parameter.name) + ' ' +
              testbench::yosys_integer(static_cast<int>(parameter.value));
  }
  return script + " ptm_evaluator" + write_top("ptm_evaluator", json);
}

ModuleCounts run_yosys(const std::string& script, const std::string& top, const std::string& json) {
  const tests::ToolRun run = tests::run_tool("yosys -q -p \"" + script + "\"");
  EXPECT_EQ(run.status, 0) << run.output;
  ModuleCounts counts;
  std::ifstream file(json);
  if (run.status == 0) {
    const nlohmann::json modules = nlohmann::json::parse(file).at("modules");
    for (const auto& [module, body] : modules.items()) {  // a parameter changes the top's name
      if (base_name(module) == top) add_instances(modules, module, counts);
    }
  }
  std::filesystem::remove(json);
  return counts;
}

ModuleCounts count_operators(const Preset& preset) {
  const std::string json =
      tests::scratch_file("operation_count_" + std::string(preset.name) + ".json");
  return run_yosys(yosys_script(preset.config, json), "ptm_evaluator", json);
}

int sum_of(const ModuleCounts& counts, std::initializer_list<const char*> modules,
           const std::string& type) {
  int sum = 0;
  for (const char* module : modules) {
    const Counts& own = counts.at(module);
    const auto found = own.find(type);
    sum += found == own.end() ? 0 : found->second;
  }
  return sum;
}

class RtlOperationCount : public testing::TestWithParam<Preset> {
 protected:
  ModuleCounts counts_ = count_operators(GetParam());
};

TEST_P(RtlOperationCount, IsElevenMultipliesAndFiveAddsInTheModulesOfD2D3D5AndD7) {
  for (const auto& [module, own] : counts_) {
    std::cout << GetParam().name << ' ' << module << ':';
    for (const auto& [type, count] : own) std::cout << ' ' << type << ' ' << count;
    std::cout << '\n';
  }
  const auto arithmetic = {"ptm_evaluator_basis", "ptm_evaluator_products", "ptm_evaluator_sum",
                           "ptm_evaluator_color_products"};
  EXPECT_EQ(sum_of(counts_, arithmetic, "$mul"), 11);
  EXPECT_EQ(sum_of(counts_, arithmetic, "$add"), 5);
  EXPECT_EQ(sum_of(counts_, {"ptm_evaluator_basis"}, "$mul"), 3);
  EXPECT_EQ(sum_of(counts_, {"ptm_evaluator_products"}, "$mul"), 5);
  EXPECT_EQ(sum_of(counts_, {"ptm_evaluator_color_products"}, "$mul"), 3);
  EXPECT_EQ(sum_of(counts_, {"ptm_evaluator_sum"}, "$add"), 5);
}

TEST_P(RtlOperationCount, FindsNothingButMultipliesAndAddsInThoseModules) {
  for (const char* module : {"ptm_evaluator_basis", "ptm_evaluator_products", "ptm_evaluator_sum",
                             "ptm_evaluator_color_products"}) {
    for (const auto& [type, count] : counts_.at(module)) {
      EXPECT_TRUE(type == "$mul" || type == "$add") << module << " holds " << count << ' ' << type;
    }
  }
}

TEST_P(RtlOperationCount, FindsNoMultiplyInAnyOtherModule) {
  for (const char* module :
       {"ptm_evaluator_unpack", "ptm_evaluator_align", "ptm_evaluator_align_term",
        "ptm_evaluator_luminance", "ptm_arith_narrow", "ptm_arith_divide_255",
        "ptm_evaluator_color_scale"}) {
    EXPECT_EQ(sum_of(counts_, {module}, "$mul"), 0) << module;
  }
  int all = 0;
  for (const auto& [module, own] : counts_) {
    for (const auto& [type, count] : own) {
      all += type == "$mul" ? count : 0;
      EXPECT_TRUE(type != "$div" && type != "$mod" && type != "$macc") << module << ' ' << type;
    }
  }
  EXPECT_EQ(all, 11);
}

INSTANTIATE_TEST_SUITE_P(Presets, RtlOperationCount, testing::ValuesIn(kPresets),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// docs/spec/unit-timing.md, Operators: three lerps a lane, one a field, U11's six and the
/// evaluator's eleven.
TEST(RtlUnitOperationCount, TheBackMultipliesInLerpsCombineAndEvaluatorOnly) {
  for (const int tmus : {1, 2, 3}) {
    const std::string json =
        tests::scratch_file("unit_operation_count_" + std::to_string(tmus) + ".json");
    const std::string script = read_all({"rtl/files.f", "rtl/unit.f"}) + "; chparam -set Tmus " +
                               std::to_string(tmus) + " ptm_back" + write_top("ptm_back", json);
    const ModuleCounts counts = run_yosys(script, "ptm_back", json);
    const int lanes = 4 * tmus + 14, fields = 26;
    EXPECT_EQ(sum_of(counts, {"ptm_arith_lerp"}, "$mul"), 3 * lanes + fields) << tmus;
    EXPECT_EQ(sum_of(counts, {"ptm_back_combine_products"}, "$mul"), 6) << tmus;
    int all = 0;
    for (const auto& [module, own] : counts) {
      for (const auto& [type, count] : own) {
        all += type == "$mul" ? count : 0;
        EXPECT_TRUE(type != "$div" && type != "$mod" && type != "$macc") << module << ' ' << type;
      }
    }
    EXPECT_EQ(all, 3 * lanes + fields + 6 + 11) << tmus;
  }
}

/// A unit built so, with that chain of stages.
ModuleCounts count_unit(const std::string& parameters, const std::vector<std::string>& effects,
                        const std::string& top = "ptm_unit") {
  const std::string json = tests::scratch_file("effect_cells_" + top + ".json");
  std::string script = read_all({"rtl/files.f", "rtl/unit.f"});
  for (const std::string& file : effects) script += ' ' + file;
  if (!parameters.empty()) script += "; chparam " + parameters + ' ' + top;
  return run_yosys(script + write_top(top, json), top, json);
}

int all_of(const ModuleCounts& counts, const std::string& type) {
  int sum = 0;
  for (const auto& [module, own] : counts) {
    const auto found = own.find(type);
    sum += found == own.end() ? 0 : found->second;
  }
  return sum;
}

constexpr const char* kSpecular = "-set HalfVector 1 -set ExtraPasses 1 -set Stages 5";
constexpr const char* kEffects =
    "-set HalfVector 1 -set ExtraSets 4 -set ExtraPasses 4 -set Stages 7";

TEST(RtlUnitEffectCells, AUnitWithoutEffectsIsThatOfATableWithoutStagesCellByCell) {
  const std::string table = tests::scratch_file("no_stages.def");
  const std::string chain = tests::scratch_file("no_stages.sv");
  std::ofstream(table) << "// no rows\n";
  ASSERT_EQ(tests::run_tool("cmake -D PTM_CHAIN_TABLE=" + table + " -D PTM_CHAIN=" + chain +
                            " -P cmake/EffectChain.cmake")
                .status,
            0);
  const ModuleCounts with = count_unit("", tests::effect_files());
  const ModuleCounts without = count_unit("", {chain});
  EXPECT_GT(all_of(with, "$mul"), 100);
  EXPECT_EQ(with, without);
  for (const auto& [module, own] : with) {
    EXPECT_EQ(module.find("ptm_effect"), std::string::npos) << module;
    for (const char* name : {"ptm_filter_sets", "ptm_filter_extra_passes",
                             "ptm_back_half_vector_fifo", "ptm_registers_by_draw"}) {
      EXPECT_NE(module, name);
    }
  }
  EXPECT_TRUE(count_unit(kSpecular, tests::effect_files()).contains("ptm_effect_power"));
  std::filesystem::remove(table);
  std::filesystem::remove(chain);
}

/// docs/spec/effects.md: a multiply a field of a set, one of the power (its lerp is not there
/// without fraction bits), three of modulate; evaluator and lanes are shared.
TEST(RtlUnitEffectCells, MultiplyInFieldsAndStagesOnly) {
  const int plain = all_of(count_unit("", tests::effect_files(), "ptm_back"), "$mul");
  struct Built {
    const char* name;
    std::string parameters;
    int more;
  };
  for (const Built& built :
       {Built{"specular", kSpecular, 1}, Built{"effects", kEffects, 24 + 1 + 3},
        Built{"specular, lum_frac 4", std::string(kSpecular) + " -set LumFrac 4", 2}}) {
    const auto counts = count_unit(built.parameters, tests::effect_files(), "ptm_back");
    const int multiplies = all_of(counts, "$mul");
    std::cout << built.name << ": " << multiplies << " $mul, " << plain << " without effects\n";
    EXPECT_EQ(multiplies, plain + built.more) << built.name;
  }
}

/// Bits of flip-flops outside memories in the front, which holds the counters, as Yosys reads it.
std::uint64_t flip_flops_of_the_front(const std::string& parameters) {
  const tests::ToolRun run = tests::run_tool(
      "yosys -p \"" + read_all({"rtl/files.f", "rtl/unit.f"}) +
      "; chparam -set CacheKib 1 -set FragmentFifo 4 -set MissFifo 12 " + parameters +
      " ptm_front; hierarchy -check -top ptm_front; proc; opt_clean; memory_collect; "
      "stat -width\"");
  EXPECT_EQ(run.status, 0) << run.output;
  std::istringstream lines(run.output.substr(run.output.find("=== design hierarchy ===")));
  std::uint64_t bits = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string cell;
    std::uint64_t count = 0;
    if (!(words >> cell >> count)) continue;
    for (const char* type : {"$dff_", "$adff_", "$dffe_", "$adffe_", "$sdff_"}) {
      if (cell.rfind(type, 0) == 0) bits += count * std::stoull(cell.substr(cell.rfind('_') + 1));
    }
  }
  return bits;
}

TEST(RtlUnitFlipFlops, LosesEveryCounterWithoutCounters) {
  const std::uint64_t with = flip_flops_of_the_front("");
  const std::uint64_t without = flip_flops_of_the_front("-set Counters 0 -set DuplicateLines 0");
  // 37 counters, the idle time, and two bits: cycles have begun, the counters are to be cleared
  constexpr std::uint64_t kCounters = 37 * 64 + 64 + 2;
  // For duplicate_lines two copies of each of the 12 tag banks, each with two ways' line addresses
  // as they were read and whether they are valid; for each bank the line that it looked up, and
  // whether it was missed
  constexpr std::uint64_t kLine = 26, kCopies = 12 * 2 * 2 * (kLine + 1) + 12 * (kLine + 1);
  EXPECT_EQ(with - without, kCounters + kCopies);
  EXPECT_GT(without, 1000U);
}

}  // namespace
}  // namespace ptm::reference
