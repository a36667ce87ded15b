// What scripts/synthesize makes of the RTL, simulated in two simulators: the evaluator of each
// preset against vectors of the reference, and the smallest unit against the Verilated one, cycle
// by cycle.
#include "tests/rtl/four_state.h"

namespace ptm::tests {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

ToolRun synthesize(const ScratchFolder& folder, const std::string& arguments) {
  ToolRun run = run_tool("PTMSIM='" PTM_PROGRAM "' scripts/synthesize --verilator --out '" +
                         (folder / "out").string() + "' " + arguments);
  std::cout << run.output;  // the table that stands in rtl/README.md
  return run;
}

TEST(Netlist, OfTheEvaluatorOfEveryPresetGivesTheReferencesPixelsInTwoSimulators) {
  const ScratchFolder folder;
  const ToolRun run = synthesize(folder, "--vectors 2000");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_EQ(count_of(run.output, "2000 vectors, 0 differ"), 3U) << run.output;
}

TEST(Netlist, OfTheSmallestUnitIsTheVerilatedUnitInEveryCycleInTwoSimulators) {
  const reference::UnitConfig smallest{.tmus = 1,
                                       .cache_kib = 1,
                                       .ways = 1,
                                       .fragment_fifo = 4,
                                       .miss_fifo = 4,
                                       .palette_lrgb_ports = 1,
                                       .palette_rgb_ports = 1,
                                       .eval_lanes = 1};
  const testbench::RtlUnitVariant variant{"smallest", reference::kBase, smallest, nullptr};
  const auto verilated = testbench::make_rtl_unit(reference::kBase, smallest);
  std::string recordings;
  for (const SmallScene& scene : small_scenes()) {
    const std::string name = scene.name;  // those whose registers are written in some 2,000 cycles
    if (name != "LrgbBilinear" && name != "PaletteLrgbDecal" && name != "ColorOnly" &&
        name != "RgbTrilinearAdd") {
      continue;
    }
    SCOPED_TRACE(name);
    recordings += recording_of(variant, *verilated, scene, 6);
  }
  const ScratchFolder folder;
  const std::string trace = folder.write("recording", recordings).string();
  const ToolRun run = synthesize(folder, "--trace '" + trace + "' unit");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_EQ(count_of(run.output, " cycles, 0 differ"), 1U) << run.output;
  EXPECT_EQ(count_of(run.output, "| unit |"), 2U) << run.output;  // heading and row

  // The replays can tell: a bit of a pixel of the recording is changed.
  const std::size_t pixel = recordings.rfind("\nC ");
  ASSERT_NE(pixel, std::string::npos);
  std::string changed = recordings;
  const std::size_t end = changed.find('\n', pixel + 1);
  changed[end - 1] = changed[end - 1] == '0' ? '1' : '0';  // the interrupt
  const std::string other = folder.write("changed", changed).string();
  const std::string out = (folder / "out").string();
  EXPECT_NE(run_tool("'" + out + "/unit_verilator/simulate' '" + other + "'").status, 0);
  const ToolRun replay = run_tool("vvp -n '" + out + "/unit.vvp' '+trace=" + other + "'");
  EXPECT_EQ(replay.output.find("replayed"), std::string::npos) << replay.output;
}

}  // namespace
}  // namespace ptm::tests
