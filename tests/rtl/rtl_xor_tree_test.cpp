// That designs are verilated with an optimiser that computes exclusive-or trees rightly: the
// options are those of cmake/PtmVerilate.cmake, which every build of the RTL takes.
#include <gtest/gtest.h>
#include <verilated.h>

#include <cstdint>
#include <random>

#include "Vptm_xor_tree.h"

namespace ptm::tests {
namespace {

TEST(VerilatedXorTree, OfABitTwiceAndAnotherIsTheOtherForEveryInput) {
  VerilatedContext context;
  Vptm_xor_tree dut(&context);
  std::mt19937_64 rng(1);
  for (int n = 0; n < 100'000; ++n) {
    dut.x_i = rng() & ((std::uint64_t{1} << 39) - 1);
    dut.eval();
    ASSERT_EQ(dut.differs_o, 0) << "x = " << dut.x_i;
  }
  dut.final();
}

}  // namespace
}  // namespace ptm::tests
