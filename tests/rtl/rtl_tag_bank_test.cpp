// Tag banks of one, two and four ways against lists of uses: docs/spec/unit-timing.md, Tags.
#include <gtest/gtest.h>

#include "Vptm_tag_bank_1.h"
#include "Vptm_tag_bank_2.h"
#include "Vptm_tag_bank_4.h"
#include "tests/rtl/tag_bank_checks.h"

namespace ptm::tests {
namespace {

TEST(RtlTagBank, OfOneWayHoldsWhatItWasAskedForLast) {
  EXPECT_EQ(check_tag_bank<Vptm_tag_bank_1>(1), "");
}

TEST(RtlTagBank, OfTwoWaysReplacesTheOneUsedLongestAgo) {
  EXPECT_EQ(check_tag_bank<Vptm_tag_bank_2>(2), "");
}

TEST(RtlTagBank, OfFourWaysReplacesTheOneUsedLongestAgo) {
  EXPECT_EQ(check_tag_bank<Vptm_tag_bank_4>(4), "");
}

}  // namespace
}  // namespace ptm::tests
