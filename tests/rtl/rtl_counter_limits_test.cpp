// Counters carry into their upper halves, and wrap at 2^64.
#include <gtest/gtest.h>

#include "Vptm_counters.h"
#include "Vptm_counters___024root.h"
#include "model/reference/unit/unit_counters.h"
#include "tests/rtl/counter_limits.h"

namespace ptm::tests {
namespace {

TEST(RtlCounterLimits, CarryAt32BitsAndWrapAt64) {
  static_assert(kLimitCounters == reference::kUnitCounters);
  EXPECT_EQ(check_counter_limits<Vptm_counters>(), "");
}

}  // namespace
}  // namespace ptm::tests
