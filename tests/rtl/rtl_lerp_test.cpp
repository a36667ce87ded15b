// The lerp of Eq. 14 in RTL against the reference, exhaustively where that is feasible.
#include <gtest/gtest.h>

#include "model/reference/lerp.h"
#include "testbench/rtl/rtl_variants.h"
#include "testbench/vectors/vector_generator.h"

namespace ptm::testbench {
namespace {

using reference::Rounding;
using reference::Value;

void expect_lerp(RtlLerp& rtl, Rounding rounding, int width, unsigned a, unsigned b, unsigned f) {
  const Value expected = reference::lerp<Value>(rounding, a, b, f);
  const unsigned got = rtl(rounding, width, a, b, f);
  if (Value{got} != expected) {
    FAIL() << "lerp(" << a << ", " << b << ", " << f << "), rounding "
           << (rounding == Rounding::nearest ? "nearest" : "truncate") << ", width " << width
           << ": rtl " << got << ", reference " << expected;
  }
}

class RtlLerpRounding : public testing::TestWithParam<Rounding> {};

TEST_P(RtlLerpRounding, EqualsTheReferenceForEvery8BitOperand) {
  const auto rtl = make_rtl_lerp();
  for (unsigned a = 0; a < 256; ++a) {
    for (unsigned b = 0; b < 256; ++b) {
      for (unsigned f = 0; f < 256; ++f) {
        expect_lerp(*rtl, GetParam(), 8, a, b, f);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST_P(RtlLerpRounding, EqualsTheReferenceOnAMillionVectorsOfTheWidestStoredValues) {
  const auto rtl = make_rtl_lerp();
  for (std::uint64_t n = 0; n < 1'000'000; ++n) {
    const LerpOperands in = lerp_vector(kLarge, 1, n);
    expect_lerp(*rtl, GetParam(), 16, static_cast<unsigned>(in.a), static_cast<unsigned>(in.b),
                static_cast<unsigned>(in.f));
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Roundings, RtlLerpRounding,
                         testing::Values(Rounding::nearest, Rounding::truncate),
                         [](const auto& tested) {
                           return tested.param == Rounding::nearest ? "nearest" : "truncate";
                         });

}  // namespace
}  // namespace ptm::testbench
