// Tests of the tests: faults planted in a copy of one block's RTL, one at a time, and the check of
// that block that notices each, compiled against the changed block. docs/verification/plan.md,
// Planted faults.
#include <gtest/gtest.h>

#include "tests/rtl/fault.h"
#include "tests/rtl/rtl_tools.h"
#include "tests/scratch_folder.h"

namespace ptm::tests {
namespace {

/// A block of the RTL, and the check of its Verilated class Vblock.
struct Block {
  std::vector<std::string> files;
  std::string top;         ///< its module and parameters, for Verilator
  std::string header;      ///< of the check
  std::string expression;  ///< what is wrong first, or an empty string
};

/// What the block's check says of it.
std::string check_block(const Block& block, const std::vector<std::string>& files) {
  const ScratchFolder folder;
  const std::filesystem::path main = folder.write(
      "main.cpp", "#include \"Vblock.h\"\n#include \"Vblock___024root.h\"\n#include \"" +
                      block.header + "\"\n#include <cstdio>\nint main() { std::puts((" +
                      block.expression + ").c_str()); }\n");
  const std::string build = (folder / "build").string();
  std::string command =
      "verilator --cc -O3 -fno-const-bit-op-tree -Wno-fatal -Irtl --prefix Vblock --Mdir " + build +
      " --top-module " + block.top;
  for (const std::string& file : files) command += ' ' + file;
  // Verilator's runtime is the build's own: it takes longer to compile than all else.
  command +=
      " && root=$(verilator --getenv VERILATOR_ROOT)/include && c++ -std=c++20 -O1 -w -I"
      "$root -I$root/vltstd -I" PTM_SOURCE_DIR " -I" +
      build + ' ' + main.string() + ' ' + build + "/*.cpp " PTM_VERILATOR_RUNTIME " -pthread -o " +
      build + "/check";
  const ToolRun made = run_tool(command);
  EXPECT_EQ(made.status, 0) << made.output;
  return run_tool(build + "/check").output;
}

struct BlockFault {
  Fault fault;
  Block block;
  std::string noticed;  ///< what the check says of the changed block, in part
};

class PlantedBlockFault : public testing::TestWithParam<BlockFault> {};

TEST_P(PlantedBlockFault, IsNoticedByTheCheckOfItsBlock) {
  const auto& [fault, block, noticed] = GetParam();
  const std::string said = check_block(block, fault.planted_in(block.files).files());
  EXPECT_NE(said.find(noticed), std::string::npos) << said;
}

/// tests/rtl/rtl_counter_limits_test.cpp
Block counters() {
  return {{"rtl/contract/ptm_register_pkg.sv", "rtl/ptm_unit_pkg.sv",
           "rtl/registers/ptm_registers_counters.sv"},
          "ptm_registers_counters -GStages=1",
          "tests/rtl/counter_limits.h",
          "ptm::tests::check_counter_limits<Vblock>()"};
}

INSTANTIATE_TEST_SUITE_P(
    Counters, PlantedBlockFault,
    testing::Values(
        BlockFault{{"CarryOfASharedCounter", "rtl/registers/ptm_registers_counters.sv",
                    "count_q[n] = count_q[n] + 64'(increment) + "
                    "(Idle ? idle_q : 64'd0);",
                    "count_q[n][31:0] = 32'(count_q[n] + 64'(increment) + "
                    "(Idle ? idle_q : 64'd0));"},
                   counters(),
                   "counter 0 from 4294967276"},
        BlockFault{{"CarryOfADrawsCounter", "rtl/registers/ptm_registers_counters.sv",
                    "draw_count_q[4*d+3] = draw_count_q[4*d+3] + 64'(misses_color);",
                    "draw_count_q[4*d+3][31:0] = 32'(draw_count_q[4*d+3] + 64'(misses_color));"},
                   counters(),
                   "counter 24 from 4294967276"}),
    [](const auto& tested) { return std::string(tested.param.fault.name); });

/// tests/rtl/rtl_tag_bank_test.cpp
Block tag_bank(unsigned ways) {
  const std::string number = std::to_string(ways);
  return {{"rtl/ptm_pkg.sv", "rtl/ptm_unit_pkg.sv", "rtl/front/ptm_front_pkg.sv",
           "rtl/memory/ptm_memory_ram.sv", "rtl/memory/ptm_memory_register_file.sv",
           "rtl/front/ptm_front_tag_copy.sv", "rtl/front/ptm_front_tag_bank.sv"},
          "ptm_front_tag_bank -GSets=4 -GTmus=3 -GTmu=1 -GWays=" + number,
          "tests/rtl/tag_bank_checks.h",
          "ptm::tests::check_tag_bank<Vblock>(" + number + ")"};
}

constexpr const char* kTouch = "if (2'(w) == way) older_after[w*Ways + other] = 1'b0;";
constexpr const char* kCompare = "tags[w*LineBits +: LineBits] == line_i)";

INSTANTIATE_TEST_SUITE_P(
    TagBanks, PlantedBlockFault,
    testing::Values(
        BlockFault{{"TwoWaysSwapped", "rtl/front/ptm_front_tag_bank.sv", kTouch,
                    "if (2'(w ^ 1) == way) older_after[w*Ways + other] = 1'b0;"},
                   tag_bank(2),
                   "expected a miss at"},
        BlockFault{{"FourWaysSwapped", "rtl/front/ptm_front_tag_bank.sv", kTouch,
                    "if (2'(w ^ 1) == way) older_after[w*Ways + other] = 1'b0;"},
                   tag_bank(4),
                   "expected a miss at"},
        BlockFault{{"HitDoesNotTouch", "rtl/front/ptm_front_tag_bank.sv", ".write_i(look_up_i)",
                    ".write_i(allocates)"},
                   tag_bank(4),
                   "expected a miss at"},
        BlockFault{{"FourthWayNeverReplaced", "rtl/front/ptm_front_tag_bank.sv",
                    "if ((older[w*Ways +: Ways] | Ways'(1 << w)) == '1) way = 2'(w);",
                    "if (w < 3 && (older[w*Ways +: Ways] | Ways'(1 << w)) == '1) way = 2'(w);"},
                   tag_bank(4),
                   "expected a miss at"},
        BlockFault{{"TagComparedWithoutItsTopBit", "rtl/front/ptm_front_tag_bank.sv", kCompare,
                    "tags[w*LineBits +: LineBits] << 1 == line_i << 1)"},
                   tag_bank(2),
                   "a hit at"},
        BlockFault{{"TagComparedWithoutItsLowestBit", "rtl/front/ptm_front_tag_bank.sv", kCompare,
                    "tags[w*LineBits +: LineBits] >> 1 == line_i >> 1)"},
                   tag_bank(1),
                   "a hit at"},
        BlockFault{{"TagWrittenAsItIsReadIsMissed", "rtl/front/ptm_front_tag_bank.sv",
                    "late_q <= allocates && read_set == set;", "late_q <= 1'b0;"},
                   tag_bank(2),
                   "expected a hit at"},
        BlockFault{{"DuplicateOnlyInWay0OfTwo", "rtl/front/ptm_front_tag_copy.sv",
                    "if (valid_q[w] && tag", "if (w == 0 && valid_q[w] && tag"},
                   tag_bank(2),
                   "missed line is not held"},
        BlockFault{{"DuplicateOnlyInThreeWaysOfFour", "rtl/front/ptm_front_tag_copy.sv",
                    "if (valid_q[w] && tag", "if (w < 3 && valid_q[w] && tag"},
                   tag_bank(4),
                   "missed line is not held"},
        BlockFault{{"DuplicateComparedOnFewerBits", "rtl/front/ptm_front_tag_copy.sv",
                    "tag[w*LineBits +: LineBits] == line_i",
                    "tag[w*LineBits +: LineBits] << 1 == line_i << 1"},
                   tag_bank(4),
                   "missed line is held"}),
    [](const auto& tested) { return std::string(tested.param.fault.name); });

/// The same checks say nothing of the blocks as they are.
TEST(PlantedBlockFaults, AreNoticedBecauseTheRightBlocksPass) {
  EXPECT_EQ(check_block(counters(), counters().files), "\n");
  for (const unsigned ways : {1U, 2U, 4U}) {
    EXPECT_EQ(check_block(tag_bank(ways), tag_bank(ways).files), "\n");
  }
}

}  // namespace
}  // namespace ptm::tests
