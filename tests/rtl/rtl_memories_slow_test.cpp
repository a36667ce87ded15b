// The same of the largest caches and FIFOs, with all that effects need.
#include "tests/rtl/unit_memories.h"

namespace ptm::tests {
namespace {

TEST_P(RtlMemories, AreAllOfTheTwoModulesAndBecomeBlockRam) { expect_block_ram(); }

INSTANTIATE_TEST_SUITE_P(
    LargeUnits, RtlMemories,
    testing::Values(Unit{"EffectsAndLargeCaches",
                         "\nchparam -set CacheKib 64 -set Ways 4 -set FragmentFifo 1024 -set "
                         "MissFifo 256 -set HalfVector 1 -set ExtraSets 4 -set ExtraPasses 4 -set "
                         "Stages 7 ptm_unit"}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::tests
