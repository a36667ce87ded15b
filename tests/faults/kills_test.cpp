// Commands killed at a few random moments; kills_slow_test.cpp takes fifty of each.
#include "tests/faults/kills.h"

namespace ptm::tests {
namespace {

TEST_P(Kills, LeaveNoHalfFileNoTemporaryFileAndNoProcess) { kill_at_moments(6); }

INSTANTIATE_TEST_SUITE_P(Commands, Kills, testing::Values("fit", "render", "run", "convert"),
                         kills_name);

}  // namespace
}  // namespace ptm::tests
