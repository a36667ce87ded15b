// The steps of sixty random configurations within the stated ranges, for every input.
#include <gtest/gtest.h>

#include "testbench/prove/evaluator_claims.h"
#include "testbench/prove/solver.h"
#include "testbench/rtl/yosys.h"
#include "tests/reference/random_config.h"

namespace ptm::testbench {
namespace {

TEST(StepClaimsOfRandomConfigurations, HoldForEveryInput) {
  std::mt19937_64 random(17);
  for (int n = 0; n < 60; ++n) {
    const reference::EvalConfig config = tests::random_config(random);
    for (const auto& claim : step_claims(config)) {
      EXPECT_EQ(prove(*claim, rtl_sources("rtl/files.f")).verdict, Verdict::holds)
          << claim->name << " of configuration " << n;
    }
  }
}

}  // namespace
}  // namespace ptm::testbench
