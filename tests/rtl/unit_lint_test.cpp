// The tools' opinion of the unit's sources: Verilator's lint, every warning an error, for every
// variant that is built and for the ends of the parameters' ranges; and that Yosys reads them.
#include <array>

#include "tests/rtl/rtl_tools.h"

namespace ptm::tests {
namespace {

struct Built {
  const char* name;
  const char* parameters;
};

class RtlUnitLint : public testing::TestWithParam<Built> {};

TEST_P(RtlUnitLint, IsClean) {
  const ToolRun run = run_tool(std::string("verilator --lint-only -Wall -Irtl -y rtl/effects "
                                           "rtl/lint.vlt -f rtl/files.f -f rtl/unit.f "
                                           "--top-module ptm_unit ") +
                               GetParam().parameters);
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_EQ(run.output, "");
}

INSTANTIATE_TEST_SUITE_P(
    Parameters, RtlUnitLint,
    testing::Values(Built{"Default", ""}, Built{"TwoTmus", "-GTmus=2"}, Built{"OneTmu", "-GTmus=1"},
                    Built{"Paper8",
                          "-GDeltaBits=8 -GLightInt=1 -GLightFrac=7 -GBasisFrac=6 -GGuard=0 "
                          "-GRoundNearest=0 -GLumBits=8 -GShiftMin=-2"},
                    Built{"Wide", "-GLightFrac=12 -GBasisFrac=16 -GGuard=10 -GLumFrac=4"},
                    Built{"Small",
                          "-GShiftGroups=3 -GCacheKib=1 -GWays=1 -GFragmentFifo=8 -GMissFifo=12 "
                          "-GPaletteLrgbPorts=2 -GPaletteRgbPorts=2 -GEvalLanes=3"},
                    Built{"Effects", "-GHalfVector=1 -GExtraSets=4 -GExtraPasses=4 -GStages=7"},
                    Built{"Specular", "-GHalfVector=1 -GExtraPasses=1 -GStages=5"},
                    Built{"EffectsOneTmuLarge",
                          "-GHalfVector=1 -GExtraSets=4 -GExtraPasses=4 -GStages=7 -GTmus=1 "
                          "-GEvalLanes=3 -GLumFrac=4 -GFilterFrac=4 -GCoefBits=10 -GLumBits=12"},
                    Built{"EffectsTwoTmusNarrow",
                          "-GHalfVector=1 -GExtraSets=2 -GExtraPasses=3 -GStages=7 -GTmus=2 "
                          "-GLumBits=8 -GRoundNearest=0"},
                    Built{"PassesOnly", "-GExtraPasses=2"},
                    Built{"SetsOnly", "-GExtraSets=1 -GExtraPasses=1"},
                    Built{"StagesOnly", "-GStages=6"},
                    Built{"NoCounters", "-GCounters=0 -GDuplicateLines=0"},
                    Built{"NoCountersEffectsOneTmu",
                          "-GCounters=0 -GDuplicateLines=0 -GHalfVector=1 -GExtraSets=4 "
                          "-GExtraPasses=4 -GStages=7 -GTmus=1"},
                    Built{"NoDuplicateLines", "-GDuplicateLines=0 -GTmus=2"},
                    Built{"OneSet", "-GCacheKib=1 -GWays=4 -GFragmentFifo=4 -GPaletteLrgbPorts=1"},
                    Built{"Large",
                          "-GCacheKib=64 -GWays=4 -GFragmentFifo=1024 -GMissFifo=256 "
                          "-GPaletteRgbPorts=4 -GCoefBits=12 -GFilterFrac=4"},
                    Built{"WideEffectsOneTmu",
                          "-GHalfVector=1 -GExtraSets=4 -GExtraPasses=4 -GStages=7 -GTmus=1 "
                          "-GCoefBits=11 -GDeltaBits=12"},
                    Built{"LargeDirectMapped", "-GCacheKib=64 -GWays=1"}),
    [](const auto& tested) { return std::string(tested.param.name); });

class RtlUnitSources : public testing::TestWithParam<Built> {};

TEST_P(RtlUnitSources, AreReadByYosysWithEveryModuleFound) {
  std::string files;
  for (const char* list : {"rtl/files.f", "rtl/unit.f"}) {
    for (const std::string& file : rtl_files(list)) files += ' ' + file;
  }
  for (const std::string& file : effect_files()) files += ' ' + file;
  const ToolRun run =
      run_tool("yosys -q -p 'read_verilog -sv -DYOSYS -Irtl" + files + GetParam().parameters +
               "; hierarchy -check -top ptm_unit; proc; check -assert'");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_EQ(run.output.find("ERROR"), std::string::npos) << run.output;
}

INSTANTIATE_TEST_SUITE_P(
    Parameters, RtlUnitSources,
    testing::Values(
        Built{"Default", ""},
        Built{"Effects",
              "; chparam -set HalfVector 1 -set ExtraSets 4 -set ExtraPasses 4 "
              "-set Stages 7 -set Tmus 1 -set EvalLanes 3 -set LumFrac 4 ptm_unit"},
        Built{"NoCounters", "; chparam -set Counters 0 -set DuplicateLines 0 ptm_unit"},
        Built{"WideSets",
              "; chparam -set CoefBits 12 -set ExtraSets 2 -set ExtraPasses 2 ptm_unit"},
        Built{"Specular", "; chparam -set HalfVector 1 -set ExtraPasses 1 -set Stages 5 ptm_unit"}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::tests
