// Steps U1 to U6 against rational arithmetic and an infinite row of texels.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/reference/unit/beats.h"
#include "tests/reference/exact_rational.h"

namespace ptm::reference {
namespace {

using tests::floor_divide;
using tests::Wide;

constexpr Wide kOne = 1 << 20;
constexpr std::array<Wrap, 3> kWraps{Wrap::repeat, Wrap::mirror, Wrap::clamp};

/// Coordinates of 34 bits: about whole and half periods, both ends, and any.
std::vector<Value> coordinates() {
  std::vector<Value> out;
  for (Value period = -5; period <= 5; ++period) {
    for (Value off = -3; off <= 3; ++off) {
      out.push_back((period << 20) + off);
      out.push_back((period << 20) + (1 << 19) + off);
    }
  }
  constexpr Value kLimit = Value{1} << 33;
  for (Value off = 0; off < 4; ++off) {
    out.push_back(-kLimit + off);
    out.push_back(kLimit - 1 - off);
  }
  std::mt19937_64 rng(1);
  std::uniform_int_distribution<Value> any(-kLimit, kLimit - 1);
  for (int n = 0; n < 20000; ++n) out.push_back(any(rng));
  return out;
}

TEST(ProbeCoordinate, IsTheMiddleOfItsPartOfTheAxisRoundedDown) {
  std::mt19937_64 rng(2);
  std::uniform_int_distribution<Value> any(-(1 << 28), (1 << 28) - 1);
  for (int log2 = 0; log2 <= 4; ++log2) {
    const int probes = 1 << log2;
    for (int n = 0; n < 2000; ++n) {
      const Value u = n == 0 ? -(1 << 28) : any(rng), axis = n < 2 ? -(1 << 28) : any(rng);
      for (int k = 0; k < probes; ++k) {
        // u + (k - (N - 1) / 2) * axis
        const Wide twice = 2 * Wide{u} + (2 * k - (probes - 1)) * Wide{axis};
        const Value got = probe_coordinate(u, axis, k, log2);
        ASSERT_EQ(Wide{got}, floor_divide(twice, 2)) << u << ' ' << axis << ' ' << k;
        ASSERT_LT(std::abs(got), Value{1} << 33) << "34 bits";
      }
    }
  }
}

TEST(ChooseLevel, IsTheNearestOrTheOneBelowWithTheFractionForEveryLod) {
  for (int levels = 1; levels <= kLevelsMax; ++levels) {
    for (Value lod = 0; lod < 4096; ++lod) {
      const double exact = static_cast<double>(lod) / 256;
      const LevelChoice none = choose_level(Mip::none, lod, levels);
      EXPECT_EQ(none.level, 0);
      EXPECT_EQ(none.weight, 0);
      const LevelChoice nearest = choose_level(Mip::nearest, lod, levels);
      EXPECT_EQ(nearest.level, std::min(levels - 1.0, std::floor(exact + 0.5)));
      EXPECT_EQ(nearest.weight, 0);
      const LevelChoice linear = choose_level(Mip::linear, lod, levels);
      const double limited = std::min(exact, levels - 1.0);
      EXPECT_EQ(linear.level + linear.weight / 256.0, limited) << lod << " of " << levels;
      EXPECT_LT(linear.level + (linear.weight != 0 ? 1 : 0), levels);
    }
  }
}

TEST(WrapCoordinate, EqualsFloorDivisionForEveryBoundaryAndHugeCoordinates) {
  for (const Value u : coordinates()) {
    const Wide period = floor_divide(u, kOne), inside = Wide{u} - period * kOne;
    const bool odd = floor_divide(period, 2) * 2 != period;
    EXPECT_EQ(Wide{wrap_coordinate(Wrap::repeat, u)}, inside) << u;
    EXPECT_EQ(Wide{wrap_coordinate(Wrap::mirror, u)}, odd ? kOne - 1 - inside : inside) << u;
    EXPECT_EQ(Wide{wrap_coordinate(Wrap::clamp, u)}, tests::limit(u, 0, kOne - 1)) << u;
  }
}

TEST(TexelPosition, IsTheNearest256thOfATexelForEverySize) {
  std::mt19937_64 rng(3);
  for (int size = 1; size <= 4096; ++size) {
    for (int n = 0; n < 60; ++n) {
      // both ends, about every texel's edge and centre in turn, and any
      Value u = static_cast<Value>(rng() % (1U << 20));
      if (n < 3) u = n;
      if (n >= 3 && n < 6) u = (1 << 20) - (n - 2);
      if (n >= 6 && n < 30) u = (2 * u / (1 << 20) * size + n % 2) * (1 << 19) / size + n % 3 - 1;
      u = std::clamp<Value>(u, 0, (1 << 20) - 1);
      const Wide product = Wide{u} * size;
      // 256 (u W - 1/2), rounded to nearest: floor of it plus a half
      const Wide s = floor_divide(512 * product - 255 * kOne, 2 * kOne);
      const TexelPosition<Value> fine = texel_position(true, u, Value{size});
      ASSERT_EQ(Wide{fine.index}, floor_divide(s, 256)) << u << " of " << size;
      ASSERT_EQ(Wide{fine.index} * 256 + fine.weight, s) << u << " of " << size;
      ASSERT_GE(fine.index, -1);
      ASSERT_LT(fine.index, size);
      const TexelPosition<Value> point = texel_position(false, u, Value{size});
      ASSERT_EQ(Wide{point.index}, product / kOne) << u << " of " << size;
      ASSERT_EQ(point.weight, 0);
    }
  }
}

TEST(Neighbour, IsTheTexelBesideTheEdgeAsTheWrapModeRepeatsIt) {
  for (int size = 1; size <= 9; ++size) {
    std::vector<std::int32_t> around(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) around[static_cast<std::size_t>(i)] = i;
    for (const Wrap wrap : kWraps) {
      std::vector<std::int32_t> row = around;
      row.insert(row.begin(), wrap == Wrap::repeat ? around.back() : around.front());
      row.push_back(wrap == Wrap::repeat ? around.front() : around.back());
      for (int i = -1; i <= size; ++i) {
        EXPECT_EQ(neighbour(wrap, i, size), row[static_cast<std::size_t>(i + 1)])
            << i << " of " << size << ", wrap " << static_cast<int>(wrap);
      }
    }
  }
}

/// Texel n of the endless row that a wrap mode stands for.
int endless(Wrap wrap, long n, int size) {
  if (wrap == Wrap::clamp) return static_cast<int>(std::clamp<long>(n, 0, size - 1));
  const long pair = ((n % (2 * size)) + 2 * size) % (2 * size);
  if (wrap == Wrap::repeat) return static_cast<int>(pair % size);
  return static_cast<int>(pair < size ? pair : 2 * size - 1 - pair);
}

TEST(ScaleCoordinate, ReadsTheEndlessRowThatTheWrapModeStandsFor) {
  std::mt19937_64 rng(4);
  for (int size = 1; size <= 9; ++size) {
    std::vector<double> row(static_cast<std::size_t>(size));
    for (double& texel : row) texel = static_cast<double>(rng() % 256);
    const auto texel = [&](int i) { return row[static_cast<std::size_t>(i)]; };
    for (const Wrap wrap : kWraps) {
      for (const Value u : coordinates()) {
        const Columns at = scale_coordinate(wrap, true, wrap_coordinate(wrap, u), size);
        ASSERT_TRUE(at.i0 >= 0 && at.i0 < size && at.i1 >= 0 && at.i1 < size);
        const double got = texel(at.i0) + (texel(at.i1) - texel(at.i0)) * at.weight / 256;
        const double x = static_cast<double>(u) / (1 << 20) * size - 0.5;
        const double left = std::floor(x);
        const double a = texel(endless(wrap, static_cast<long>(left), size));
        const double b = texel(endless(wrap, static_cast<long>(left) + 1, size));
        // U4 is at most 1/512 of a texel off, U3's inversion one 2^-20 of the row; a texel's
        // neighbours differ by 255 at most, on both sides of a texel.
        const double bound = 255 * (1.0 / 512 + static_cast<double>(size) / (1 << 20)) + 1e-9;
        ASSERT_NEAR(got, a + (b - a) * (x - left), bound)
            << u << " of " << size << ", wrap " << static_cast<int>(wrap);
      }
    }
  }
}

Draw two_textures() {
  Draw draw;
  draw.mip = Mip::linear;
  draw.combine = Combine::modulate;
  draw.color = true;
  draw.map = {100, 60, 7, {}};
  draw.color_texture = {16, 16, 5, {}};
  return draw;
}

TEST(Footprint, IsTwoOnlyWhereATextureOfTheDrawHasAFraction) {
  Draw draw = two_textures();
  UnitFragment f;
  f.lod = 512;
  EXPECT_EQ(footprint_count(draw, f), 1);
  draw.color_lod = -100;  // 412: the colour texture lies between levels 1 and 2
  EXPECT_EQ(footprint_count(draw, f), 2);
  EXPECT_TRUE(make_footprint(draw, f, 0, 0, 0).fetched);
  EXPECT_FALSE(make_footprint(draw, f, 0, 0, 1).fetched);
  EXPECT_EQ(make_footprint(draw, f, 0, 0, 1).taps(), 0U);
  EXPECT_EQ(make_footprint(draw, f, 1, 0, 0).level, 1);
  EXPECT_EQ(make_footprint(draw, f, 1, 0, 1).level, 2);
  EXPECT_EQ(make_footprint(draw, f, 1, 0, 1).level_weight, 156);
  draw.color_lod = -600;  // below 0
  EXPECT_EQ(footprint_count(draw, f), 1);
  draw.color_lod = 4000;  // beyond its last level
  EXPECT_EQ(footprint_count(draw, f), 1);
  EXPECT_EQ(make_footprint(draw, f, 1, 0, 0).level, 4);
  draw.color_lod = -100;
  draw.color = false;
  EXPECT_EQ(footprint_count(draw, f), 1);
  EXPECT_FALSE(make_footprint(draw, f, 1, 0, 0).fetched);
  f.lod = 600;
  EXPECT_EQ(footprint_count(draw, f), 2);
  draw.format = TextureFormat::none;
  EXPECT_EQ(footprint_count(draw, f), 1) << "a map that the draw has not";
}

TEST(Footprint, FetchesNoTapOfWeightZero) {
  Draw draw = two_textures();
  UnitFragment f;  // centre of texel (25, 15) of 100 x 60: (25.5, 15.5)
  f.u = static_cast<std::int32_t>(25.5 / 100 * (1 << 20) + 0.5);
  f.v = static_cast<std::int32_t>(15.5 / 60 * (1 << 20) + 0.5);
  Footprint at = make_footprint(draw, f, 0, 0, 0);
  EXPECT_EQ(at.i0, 25);
  EXPECT_EQ(at.j0, 15);
  EXPECT_EQ(at.taps(), 0b0001U);
  f.u += (1 << 20) / 400;  // a quarter of a texel
  at = make_footprint(draw, f, 0, 0, 0);
  EXPECT_EQ(at.wu, 64);
  EXPECT_EQ(at.taps(), 0b0011U);
  f.v += (1 << 20) / 120;  // half a texel
  at = make_footprint(draw, f, 0, 0, 0);
  EXPECT_EQ(at.wv, 128);
  EXPECT_EQ(at.taps(), 0b1111U);
  f.u -= (1 << 20) / 400;
  EXPECT_EQ(make_footprint(draw, f, 0, 0, 0).taps(), 0b0101U);
  draw.bilinear = false;
  EXPECT_EQ(make_footprint(draw, f, 0, 0, 0).taps(), 0b0001U);
}

}  // namespace
}  // namespace ptm::reference
