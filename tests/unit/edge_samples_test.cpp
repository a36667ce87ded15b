// Which point samples lie on an edge between texels: where rounding the coordinate to 2^-20 changes
// the texel, in exact integers.
#include "testbench/run/edge_samples.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ptm::testbench {
namespace {

using reference::Wrap;

/// floor(n / d) for d > 0.
long floor_division(long n, long d) { return n / d - (n % d < 0 ? 1 : 0); }

/// The texel of the endless row that the wrap mode leaves of texel k.
long wrapped(long k, long size, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::min(std::max(k, 0L), size - 1);
  const long period = wrap == Wrap::mirror ? 2 * size : size;
  const long within = k - floor_division(k, period) * period;
  return within < size ? within : period - 1 - within;
}

/// Whether the texels just below and just above n / d, each within the rounding of 2^-20, are
/// different ones; exactly, in units of 1 / (d 2^21).
bool may_change(long n, long d, long size, Wrap wrap) {
  const long coordinate = n << 21, whole = d << 21;
  if ((n << 20) % d == 0) return false;
  const long below = floor_division((coordinate - d) * size - 1, whole);
  const long above = floor_division((coordinate + d) * size, whole);
  return wrapped(below, size, wrap) != wrapped(above, size, wrap);
}

class EdgeSamples : public testing::TestWithParam<Wrap> {
 protected:
  void expect_exact(long n, long d, int size) {
    const bool expected = may_change(n, d, size, GetParam());
    EXPECT_EQ(on_texel_edge(static_cast<double>(n) / static_cast<double>(d), size, GetParam()),
              expected)
        << size << " texels, coordinate " << n << " / " << d;
    ++(expected ? on_edge_ : off_edge_);
  }
  int on_edge_ = 0, off_edge_ = 0;
};

/// Pixel centres of pictures of other sizes: on an edge or far from all.
TEST_P(EdgeSamples, AreThoseWhoseRoundingReachesAnotherTexelByExactIntegers) {
  for (const int size : {1, 2, 3, 10, 64, 500}) {
    for (const int width : {1, 3, 5, 7, 32, 100, 250, 499}) {
      for (int x = -2 * width; x < 3 * width; ++x) expect_exact(2 * x + 1, 2 * width, size);
    }
  }
  EXPECT_GT(on_edge_, 100);
  EXPECT_GT(off_edge_, 1000);
}

/// Every sixteenth of 2^-20 around every edge, to beyond where rounding reaches.
TEST_P(EdgeSamples, EndWhereRoundingReachesNoEdge) {
  constexpr long kSteps = 1L << 24;
  for (const int size : {3, 10, 64, 500}) {
    for (long edge = -size; edge <= 2 * size; ++edge) {
      const long nearest = floor_division(2 * edge * kSteps + size, 2 * size);
      for (long off = -12; off <= 12; ++off) expect_exact(nearest + off, kSteps, size);
    }
  }
  EXPECT_GT(on_edge_, 1000);
  EXPECT_GT(off_edge_, 1000);
}

INSTANTIATE_TEST_SUITE_P(Wraps, EdgeSamples,
                         testing::Values(Wrap::repeat, Wrap::mirror, Wrap::clamp));

TEST(EdgeSamplesOfADraw, AreThoseOfPointSamplesInEitherTexture) {
  reference::Draw draw;
  draw.map.width = draw.map.height = 10;
  draw.color_texture.width = draw.color_texture.height = 3;
  draw.bilinear = false;
  draw.wrap_u = draw.wrap_v = Wrap::clamp;
  EXPECT_TRUE(on_texel_edge(0.3, 0.05, 0, draw));
  EXPECT_TRUE(on_texel_edge(0.05, 0.3, 0, draw));
  EXPECT_FALSE(on_texel_edge(0.05, 0.05, 0, draw));
  EXPECT_FALSE(on_texel_edge(1.0 / 3, 0.05, 0, draw)) << "no colour texture is fetched";
  draw.color = true;
  EXPECT_TRUE(on_texel_edge(1.0 / 3, 0.05, 0, draw));
  draw.color = false;
  draw.mip = reference::Mip::linear;  // levels of 10, 5, 2 and 1 texels
  draw.map.levels = 4;
  EXPECT_TRUE(on_texel_edge(0.7, 0.05, 0, draw));
  EXPECT_FALSE(on_texel_edge(0.7, 0.05, 1.25, draw)) << "7 tenths part no fifths";
  EXPECT_TRUE(on_texel_edge(0.4, 0.05, 1.25, draw));
  EXPECT_FALSE(on_texel_edge(0.4, 0.05, 9, draw)) << "one texel has no edge under clamp";
  draw.map.width = 7;  // levels of 7 and 3 texels: thirds part the second's only
  draw.map.levels = 2;
  EXPECT_TRUE(on_texel_edge(1.0 / 3, 0.05, 0.5, draw));
  draw.bilinear = true;
  EXPECT_FALSE(on_texel_edge(0.3, 0.3, 0, draw)) << "weights are continuous there";
}

}  // namespace
}  // namespace ptm::testbench
