// An illegal parameter stops elaboration in Verilator, Yosys and Icarus Verilog, each naming the
// fault; a legal one, ends of ranges included, stops none.
#include "tests/rtl/rtl_tools.h"

namespace ptm::tests {
namespace {

struct Set {
  const char* parameters;  ///< "Name=value Name=value"
  const char* fault;       ///< the module that is missing; empty if the set is legal
};

/// As the test's name, and so that a failing one can be found.
std::string name_of(const Set& set) {
  std::string name;
  for (const char c : std::string(set.parameters)) {
    name += c == '-' ? 'M' : std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return name.empty() ? "Defaults" : name;
}

/// Each "Name=value" through a function, joined.
template <class Write>
std::string each(const Set& set, Write write) {
  std::istringstream in(set.parameters);
  std::string text;
  for (std::string one; in >> one;) {
    const std::size_t at = one.find('=');
    text += write(one.substr(0, at), std::stoi(one.substr(at + 1)));
  }
  return text;
}

std::string joined(const std::vector<std::string>& files) {
  std::string text;
  for (const std::string& file : files) text += ' ' + file;
  return text;
}

ToolRun verilator(const std::string& top, const std::string& lists, const Set& set) {
  return run_tool("verilator --lint-only -Wall -Irtl -y rtl/effects rtl/lint.vlt " + lists +
                  " --top-module " + top + each(set, [](const std::string& name, int value) {
                    return " -G" + name + '=' + std::to_string(value);
                  }));
}

ToolRun yosys(const std::string& top, const std::string& files, const Set& set) {
  const std::string changes = each(set, [](const std::string& name, int value) {
    return " -set " + name + ' ' + testbench::yosys_integer(value);
  });
  return run_tool("yosys -q -p \"read_verilog -sv -Irtl" + files + "; " +
                  (changes.empty() ? "" : "chparam" + changes + ' ' + top + "; ") +
                  "hierarchy -check -top " + top + '"');
}

ToolRun icarus(const std::string& top, const std::string& files, const Set& set) {
  return run_tool(
      "iverilog -g2012 -Irtl -o /dev/null -s " + top +
      each(set, [&](const std::string& name,
                    int value) { return " -P" + top + '.' + name + '=' + std::to_string(value); }) +
      files);
}

void expect(const char* tool, const ToolRun& run, const Set& set) {
  SCOPED_TRACE(std::string(tool) + ": " + run.output);
  if (*set.fault == '\0') {
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.output.find("ptm_illegal"), std::string::npos);
  } else {
    EXPECT_NE(run.status, 0);
    EXPECT_NE(run.output.find(std::string("ptm_illegal_") + set.fault), std::string::npos);
  }
}

const Set kEvaluator[] = {
    {"", ""},
    {"CoefBits=4", ""},
    {"CoefBits=12 DeltaBits=13", ""},
    {"CoefBits=3", "CoefBits_not_4_to_12"},
    {"CoefBits=13", "CoefBits_not_4_to_12"},
    {"DeltaBits=5", ""},
    {"DeltaBits=4", "DeltaBits_not_5_to_13"},
    {"DeltaBits=14", "DeltaBits_not_5_to_13"},
    {"LightInt=1", ""},
    {"LightInt=3", ""},
    {"LightInt=0", "LightInt_not_1_to_3"},
    {"LightInt=4", "LightInt_not_1_to_3"},
    {"LightFrac=14", ""},
    {"LightFrac=4", ""},  // and BasisFrac twice that
    {"LightFrac=3 BasisFrac=4", "LightFrac_not_4_to_14"},
    {"LightFrac=15", "LightFrac_not_4_to_14"},
    {"BasisFrac=16", ""},
    {"BasisFrac=4", ""},
    {"BasisFrac=3", "BasisFrac_not_4_to_twice_LightFrac"},
    {"BasisFrac=17", "BasisFrac_not_4_to_twice_LightFrac"},
    {"LightFrac=4 BasisFrac=9", "BasisFrac_not_4_to_twice_LightFrac"},
    {"LightFrac=14 BasisFrac=28", ""},
    {"Guard=0", ""},
    {"Guard=12", ""},
    {"Guard=-1", "Guard_not_0_to_12"},
    {"Guard=13", "Guard_not_0_to_12"},
    {"RoundNearest=0", ""},
    {"RoundNearest=2", "RoundNearest_not_0_or_1"},
    {"RoundNearest=-1", "RoundNearest_not_0_or_1"},
    {"LumBits=8", ""},
    {"LumBits=12", ""},
    {"LumBits=7", "LumBits_not_8_to_12"},
    {"LumBits=13", "LumBits_not_8_to_12"},
    {"LumFrac=4", ""},
    {"LumFrac=-1", "LumFrac_not_0_to_4"},
    {"LumFrac=5", "LumFrac_not_0_to_4"},
    {"ShiftMin=-8", ""},
    {"ShiftMin=0", ""},
    {"ShiftMin=-9", "ShiftMin_not_minus_8_to_0"},
    {"ShiftMin=1", "ShiftMin_not_minus_8_to_0"},
    {"ShiftGroups=3", ""},
    {"ShiftGroups=4", "ShiftGroups_not_3_or_6"},
    {"ShiftGroups=0", "ShiftGroups_not_3_or_6"},
    {"FilterFrac=4", ""},
    {"FilterFrac=-1", "FilterFrac_not_0_to_4"},
    {"FilterFrac=5", "FilterFrac_not_0_to_4"},
    {"Assemble=0", ""},
    {"Assemble=2", "Assemble_not_0_or_1"},
    {"SidebandBits=1", ""},
    {"SidebandBits=0", "SidebandBits_not_1_or_more"},
};

class EvaluatorParameters : public testing::TestWithParam<Set> {};

TEST_P(EvaluatorParameters, StopElaborationWhereTheyAreIllegalAndNowhereElse) {
  const std::string files = joined(rtl_files());
  expect("Verilator", verilator("ptm_evaluator", "-f rtl/files.f", GetParam()), GetParam());
  expect("Yosys", yosys("ptm_evaluator", files, GetParam()), GetParam());
  expect("Icarus Verilog", icarus("ptm_evaluator", files, GetParam()), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Sets, EvaluatorParameters, testing::ValuesIn(kEvaluator),
                         [](const auto& tested) { return name_of(tested.param); });

const Set kUnit[] = {
    {"", ""},
    {"CoefBits=12", ""},
    {"CoefBits=13", "CoefBits_not_4_to_12"},
    {"CoefBits=3", "CoefBits_not_4_to_12"},
    {"DeltaBits=14", "DeltaBits_not_5_to_13"},
    {"LightInt=4", "LightInt_not_1_to_3"},
    {"LightFrac=15", "LightFrac_not_4_to_14"},
    {"BasisFrac=17", "BasisFrac_not_4_to_twice_LightFrac"},
    {"Guard=13", "Guard_not_0_to_12"},
    {"RoundNearest=2", "RoundNearest_not_0_or_1"},
    {"LumBits=13", "LumBits_not_8_to_12"},
    {"LumFrac=5", "LumFrac_not_0_to_4"},
    {"ShiftMin=-9", "ShiftMin_not_minus_8_to_0"},
    {"ShiftGroups=5", "ShiftGroups_not_3_or_6"},
    {"FilterFrac=5", "FilterFrac_not_0_to_4"},
    {"Tmus=1", ""},
    {"Tmus=0", "Tmus_not_1_to_3"},
    {"Tmus=4", "Tmus_not_1_to_3"},
    {"CacheKib=1", ""},
    {"CacheKib=64", ""},
    {"CacheKib=0", "CacheKib_not_1_2_4_8_16_32_or_64"},
    {"CacheKib=3", "CacheKib_not_1_2_4_8_16_32_or_64"},
    {"CacheKib=48", "CacheKib_not_1_2_4_8_16_32_or_64"},
    {"CacheKib=128", "CacheKib_not_1_2_4_8_16_32_or_64"},
    {"Ways=1", ""},
    {"Ways=4", ""},
    {"CacheKib=1 Ways=4", ""},
    {"Ways=3", "Ways_not_1_2_or_4"},
    {"Ways=8", "Ways_not_1_2_or_4"},
    {"FragmentFifo=4", ""},
    {"FragmentFifo=1024", ""},
    {"FragmentFifo=3", "FragmentFifo_not_4_to_1024"},
    {"FragmentFifo=1025", "FragmentFifo_not_4_to_1024"},
    {"MissFifo=12", ""},
    {"MissFifo=256", ""},
    {"MissFifo=4 Tmus=1", ""},
    {"MissFifo=11", "MissFifo_not_4_times_Tmus_to_256"},
    {"MissFifo=7 Tmus=2", "MissFifo_not_4_times_Tmus_to_256"},
    {"MissFifo=3 Tmus=1", "MissFifo_not_4_times_Tmus_to_256"},
    {"MissFifo=257", "MissFifo_not_4_times_Tmus_to_256"},
    {"MissFifo=300 Ways=3 CoefBits=13", "Ways_not_1_2_or_4"},  // one of three
    {"PaletteLrgbPorts=1", ""},
    {"PaletteLrgbPorts=3", "PaletteLrgbPorts_not_1_2_or_4"},
    {"PaletteLrgbPorts=0", "PaletteLrgbPorts_not_1_2_or_4"},
    {"PaletteRgbPorts=4", ""},
    {"PaletteRgbPorts=3", "PaletteRgbPorts_not_1_2_or_4"},
    {"PaletteRgbPorts=8", "PaletteRgbPorts_not_1_2_or_4"},
    {"EvalLanes=3", ""},
    {"EvalLanes=2", "EvalLanes_not_1_or_3"},
    {"EvalLanes=0", "EvalLanes_not_1_or_3"},
    {"HalfVector=1 ExtraPasses=1", ""},
    {"HalfVector=2 ExtraPasses=1", "HalfVector_not_0_or_1"},
    {"HalfVector=1", "HalfVector_without_ExtraPasses"},
    {"ExtraPasses=4 ExtraSets=4", ""},
    {"ExtraPasses=5", "ExtraPasses_not_0_to_4"},
    {"ExtraPasses=-1", "ExtraPasses_not_0_to_4"},
    {"ExtraPasses=2 ExtraSets=3", "ExtraSets_not_0_to_ExtraPasses"},
    {"ExtraSets=1", "ExtraSets_not_0_to_ExtraPasses"},
    {"ExtraSets=-1", "ExtraSets_not_0_to_ExtraPasses"},
    {"Stages=7 ExtraPasses=1", ""},
    {"Counters=0 DuplicateLines=0", ""},
    {"DuplicateLines=0", ""},
    {"Counters=2", "Counters_not_0_or_1"},
    {"Counters=-1", "Counters_not_0_or_1"},
    {"DuplicateLines=2", "DuplicateLines_not_0_or_1"},
    {"Counters=0", "DuplicateLines_without_Counters"},
    {"Stages=256", "Stages_not_a_mask_of_8_bits"},
    {"Stages=-1", "Stages_not_a_mask_of_8_bits"},
};

class UnitParameters : public testing::TestWithParam<Set> {};

/// Icarus Verilog 11 does not read the unit's sources, and Yosys takes a second for them: both are
/// asked about the module that ptm_unit hands its parameters to, which Verilator shows it does.
TEST_P(UnitParameters, StopElaborationWhereTheyAreIllegalAndNowhereElse) {
  const std::string files =
      " rtl/contract/ptm_evaluator_parameters.sv "
      "rtl/contract/ptm_unit_parameters.sv";
  expect("Verilator", verilator("ptm_unit", "-f rtl/files.f -f rtl/unit.f", GetParam()),
         GetParam());
  expect("Yosys", yosys("ptm_unit_parameters", files, GetParam()), GetParam());
  expect("Icarus Verilog", icarus("ptm_unit_parameters", files, GetParam()), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Sets, UnitParameters, testing::ValuesIn(kUnit),
                         [](const auto& tested) { return name_of(tested.param); });

TEST(UnitParametersOfTheWholeUnit, StopYosysToo) {
  std::vector<std::string> files = rtl_files();
  for (const auto& more : {rtl_files("rtl/unit.f"), effect_files()}) {
    files.insert(files.end(), more.begin(), more.end());
  }
  for (const Set& set : {Set{"Tmus=2", ""}, Set{"Ways=3", "Ways_not_1_2_or_4"},
                         Set{"ExtraPasses=1 Stages=8", "Stages_that_this_build_has_not"}}) {
    expect("Yosys", yosys("ptm_unit", joined(files), set), set);
  }
}

/// With values that leave a vector no bits Verilator stops before it comes to the missing module.
TEST(ParametersThatLeaveAVectorNoBits, StopVerilatorToo) {
  for (const char* parameters : {"Ways=0", "CoefBits=0", "CoefBits=-1", "DeltaBits=0"}) {
    const ToolRun run =
        verilator("ptm_unit", "-f rtl/files.f -f rtl/unit.f", Set{parameters, nullptr});
    EXPECT_NE(run.status, 0) << parameters;
  }
}

TEST(StagesParameter, NamesStagesThatTheBuildHas) {
  const Set set{"Stages=8 ExtraPasses=1", "Stages_that_this_build_has_not"};
  expect("Verilator", verilator("ptm_unit", "-f rtl/files.f -f rtl/unit.f", set), set);
}

TEST(LerpParameters, StopElaborationWhereTheyAreIllegal) {
  const std::string files = " rtl/ptm_pkg.sv rtl/arith/ptm_arith_lerp.sv";
  for (const Set& set : {Set{"Width=16", ""}, Set{"Width=0", "Width_not_1_or_more"},
                         Set{"RoundNearest=2", "RoundNearest_not_0_or_1"}}) {
    expect("Verilator", verilator("ptm_arith_lerp", "-f rtl/files.f", set), set);
    expect("Yosys", yosys("ptm_arith_lerp", files, set), set);
    expect("Icarus Verilog", icarus("ptm_arith_lerp", files, set), set);
  }
}

}  // namespace
}  // namespace ptm::tests
