// Which point samples lie on an edge between texels: where rounding the coordinate to 2^-20 changes
// the texel, in exact integers.
#include "testbench/run/edge_samples.h"

#include <gtest/gtest.h>

#include <cmath>

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

/// Whether the texels just below and just above (2x + 1) / (2 width), each within the rounding of
/// 2^-20, are different ones; exactly, in units of 1 / (2 width 2^21).
bool may_change(long x, long width, long size, Wrap wrap) {
  const long coordinate = (2 * x + 1) << 21, unit = 2 * width, whole = unit << 21;
  if (((2 * x + 1) << 20) % unit == 0) return false;
  const long below = floor_division((coordinate - unit) * size - 1, whole);
  const long above = floor_division((coordinate + unit) * size, whole);
  return wrapped(below, size, wrap) != wrapped(above, size, wrap);
}

TEST(EdgeSamples, AreThoseWhoseRoundingReachesAnotherTexelByExactIntegers) {
  int on_edge = 0, off_edge = 0;
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp}) {
    for (const int size : {1, 2, 3, 10, 64, 500}) {
      for (const int width : {1, 3, 5, 7, 32, 100, 250, 499}) {
        for (int x = -2 * width; x < 3 * width; ++x) {
          const double u = (x + 0.5) / width;
          const bool expected = may_change(x, width, size, wrap);
          EXPECT_EQ(on_texel_edge(u, size, wrap), expected)
              << "wrap " << static_cast<int>(wrap) << ", " << size << " texels, sample " << x
              << " of " << width;
          ++(expected ? on_edge : off_edge);
        }
      }
    }
  }
  EXPECT_GT(on_edge, 1000);
  EXPECT_GT(off_edge, 1000);
}

TEST(EdgeSamples, OfADrawAreThoseOfPointSamplesInEitherTexture) {
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
  draw.bilinear = true;
  EXPECT_FALSE(on_texel_edge(0.3, 0.3, 0, draw)) << "weights are continuous there";
}

}  // namespace
}  // namespace ptm::testbench
