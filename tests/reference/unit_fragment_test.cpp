// From plain doubles to a fragment of the unit.
#include "model/reference/unit/unit_fragment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "model/reference/unit/beats.h"

namespace ptm::reference {
namespace {

constexpr std::int32_t kOne = 1 << 20, kLimit = 1 << 28;

UnitFragment quantized(const PlainUnitSample& sample, Wrap wrap = Wrap::repeat) {
  Draw draw;
  draw.wrap_u = draw.wrap_v = wrap;
  return quantize_unit_fragment(kBase, draw, sample).value();
}

TEST(UnitFragment, RoundsCoordinatesToTheNearestOfTheirFormat) {
  PlainUnitSample s;
  s.x = 16383;
  s.y = 5;
  s.u = 0.3;
  s.v = -1.25;
  s.axis_u = -0.001;
  s.axis_v = 3.5 / kOne;  // a tie: upwards
  s.lod = 3.3;
  s.probes_log2 = 4;
  s.lu = 0.5;
  s.lv = -0.25;
  s.draw = 3;
  s.lit = false;
  const UnitFragment f = quantized(s, Wrap::clamp);
  EXPECT_EQ(f.u, std::lround(0.3 * kOne));
  EXPECT_EQ(f.v, -kOne - kOne / 4);
  EXPECT_EQ(f.axis_u, std::lround(-0.001 * kOne));
  EXPECT_EQ(f.axis_v, 4);
  EXPECT_EQ(f.lod, std::lround(3.3 * 256));
  EXPECT_EQ(f.lu, 128);
  EXPECT_EQ(f.lv, -64);
  EXPECT_EQ(f.x, 16383);
  EXPECT_EQ(f.y, 5);
  EXPECT_EQ(f.probes_log2, 4);
  EXPECT_EQ(f.draw, 3);
  EXPECT_FALSE(f.lit);
}

TEST(UnitFragment, KeepsAHugeCoordinateExactWhereTheTextureRepeats) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror}) {
    for (const double periods : {-1e9, -1001.0, -3.0, -1.0, 0.0, 1.0, 7.0, 12345.0, 1e9 + 1}) {
      for (const double fraction : {0.0, 0.125, 0.5, 0.96875}) {
        PlainUnitSample far, near;
        far.u = far.v = periods + fraction;
        near.u = near.v = std::fmod(periods, 2.0) + fraction;
        const UnitFragment f = quantized(far, wrap), n = quantized(near, wrap);
        EXPECT_EQ(wrap_coordinate(wrap, Value{f.u}), wrap_coordinate(wrap, Value{n.u}))
            << periods << " + " << fraction;
        EXPECT_EQ(wrap_coordinate(wrap, Value{f.v}), wrap_coordinate(wrap, Value{n.v}));
        EXPECT_EQ(n.u, (std::fmod(periods, 2.0) + fraction) * kOne);
        EXPECT_LE(std::abs(f.u), 2 * kOne);
      }
    }
  }
}

TEST(UnitFragment, LimitsClampedCoordinatesAxisAndLodToWhatTheyHold) {
  PlainUnitSample s;
  s.u = 1e30;
  s.v = -1e30;
  s.axis_u = -300;
  s.axis_v = 300;
  s.lod = 99;
  UnitFragment f = quantized(s, Wrap::clamp);
  EXPECT_EQ(f.u, kLimit - 1);
  EXPECT_EQ(f.v, -kLimit);
  EXPECT_EQ(f.axis_u, -kLimit);
  EXPECT_EQ(f.axis_v, kLimit - 1);
  EXPECT_EQ(f.lod, 4095);
  s.lod = -7;
  EXPECT_EQ(quantized(s).lod, 0) << "magnification";
}

TEST(UnitFragment, IsNoneForWhatHasNoCode) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  using Break = std::function<void(PlainUnitSample&)>;
  const std::vector<Break> breaks{
      [&](auto& s) { s.u = nan; },         [&](auto& s) { s.v = infinite; },
      [&](auto& s) { s.lod = -infinite; }, [&](auto& s) { s.axis_u = nan; },
      [&](auto& s) { s.axis_v = nan; },    [&](auto& s) { s.lu = 2.001; },
      [&](auto& s) { s.lv = nan; },        [&](auto& s) { s.x = -1; },
      [&](auto& s) { s.y = 16384; },       [&](auto& s) { s.probes_log2 = 5; },
      [&](auto& s) { s.draw = 4; },        [&](auto& s) { s.draw = -1; }};
  EXPECT_TRUE(quantize_unit_fragment(kBase, Draw{}, PlainUnitSample{}).has_value());
  for (std::size_t n = 0; n < breaks.size(); ++n) {
    PlainUnitSample s;
    breaks[n](s);
    EXPECT_FALSE(quantize_unit_fragment(kBase, Draw{}, s).has_value()) << "case " << n;
  }
}

}  // namespace
}  // namespace ptm::reference
