// Every command killed at fifty random moments.
#include "tests/faults/kills.h"

namespace ptm::tests {
namespace {

using SlowKills = Kills;

TEST_P(SlowKills, LeaveNoHalfFileNoTemporaryFileAndNoProcess) { kill_at_moments(50); }

INSTANTIATE_TEST_SUITE_P(Commands, SlowKills,
                         testing::Values("fit", "render", "run", "convert", "convert_mip", "bump",
                                         "synthesize"),
                         kills_name);

}  // namespace
}  // namespace ptm::tests
