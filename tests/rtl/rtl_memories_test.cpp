// Every memory of the unit maps to block RAM.
#include "tests/rtl/unit_memories.h"

namespace ptm::tests {
namespace {

TEST_P(RtlMemories, AreAllOfTheTwoModulesAndBecomeBlockRam) { expect_block_ram(); }

INSTANTIATE_TEST_SUITE_P(
    Units, RtlMemories,
    testing::Values(Unit{"Default", ""},
                    Unit{
                        "Small",
                        "\nchparam -set CacheKib 1 -set Ways 1 -set FragmentFifo 8 -set MissFifo "
                        "12 -set ShiftGroups 3 -set EvalLanes 3 -set PaletteLrgbPorts 2 ptm_unit"}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::tests
