#include "golden/scene/surface_samples.h"

#include <cmath>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>

#include "tests/golden/made_samples.h"

namespace ptm::golden {
namespace {

TEST_F(Samples, ComeInTilesFromTheTopLeftAndInScanLinesWithinThem) {
  make(kMap + kSquareOn + kLight);
  std::size_t n = 0;
  for (int ty = 0; ty < 12; ty += 8) {
    for (int tx = 0; tx < 20; tx += 8) {
      for (int y = ty; y < std::min(ty + 8, 12); ++y) {
        for (int x = tx; x < std::min(tx + 8, 20); ++x, ++n) {
          ASSERT_EQ(samples_.at(n).x, x);
          ASSERT_EQ(samples_.at(n).y, y);
        }
      }
    }
  }
  EXPECT_EQ(samples_.size(), n);
}

TEST_F(Samples, ComeInScanLinesWhereTheSceneSaysSo) {
  make(kMap + "[image]\nsize = [5, 3]\ntraversal = \"scan\"\n" +
       kSquareOn.substr(kSquareOn.find("[camera]")) + kLight);
  ASSERT_EQ(samples_.size(), 15U);
  for (int n = 0; n < 15; ++n) {
    EXPECT_EQ(samples_[static_cast<std::size_t>(n)].x, n % 5);
    EXPECT_EQ(samples_[static_cast<std::size_t>(n)].y, n / 5);
  }
}

TEST_F(Samples, OfAPlaneSeenSquareOnAreWhatArithmeticSays) {
  make(kMap + kSquareOn + "uv_scale = [4, 2]\nuv_offset = [100, -7]\n" + kLight);
  const double pixel = 2.0 / 12;
  const SurfaceSample& s = at(3, 2);
  const double x = (3.5 - 10) * pixel, z = (6 - 2.5) * pixel;
  EXPECT_NEAR(s.u, 100 + 4 * (x + 5) / 10, 1e-12);
  EXPECT_NEAR(s.v, -7 + 2 * (5 - z) / 10, 1e-12);
  EXPECT_NEAR(s.dudx, 4 * pixel / 10, 1e-12);
  EXPECT_NEAR(s.dvdy, 2 * pixel / 10, 1e-12);
  EXPECT_NEAR(s.dvdx, 0, 1e-12);
  EXPECT_NEAR(s.dudy, 0, 1e-12);
  EXPECT_NEAR(s.lod, std::log2(64 * 4 * pixel / 10), 1e-12);
  EXPECT_NEAR(s.light[0], 0, 1e-12);
  EXPECT_NEAR(s.light[1], 0, 1e-12);
  EXPECT_TRUE(s.lit);
}

TEST_F(Samples, CoverEveryPixelAtMostOnceAndThePlaneBehindAllBelowTheHorizon) {
  make(kMap + kThree + kLight);
  std::set<std::pair<int, int>> seen;
  std::map<int, int> objects;
  for (const SurfaceSample& s : samples_) {
    EXPECT_TRUE(seen.insert({s.x, s.y}).second);
    ++objects[s.object];
  }
  EXPECT_GT(objects[0], 200);
  EXPECT_GT(objects[1], 200);
  for (int x = 0; x < 96; ++x) EXPECT_TRUE(seen.count({x, 63}));
}

/// A picture of 1001 times as many pixels a side has rays close enough for differences.
TEST_F(Samples, HaveTheDerivativesOfFiniteDifferences) {
  make(kMap + kThree + kLight);
  const std::vector<SurfaceSample> coarse = samples_;
  int compared = 0;
  for (std::size_t n = 0; n < coarse.size(); n += 37) {
    const SurfaceSample& s = coarse[n];
    UnitScene fine = scene_;
    constexpr int k = 1001;  // odd: the coarse centre is a fine centre
    fine.size = {96 * k, 64 * k};
    fine.traversal = Traversal::scan;
    const auto ask = [&](int dx, int dy) {
      return sample_pixel(fine, textures_, 0, s.x * k + k / 2 + dx, s.y * k + k / 2 + dy);
    };
    const auto here = ask(0, 0), right = ask(1, 0), left = ask(-1, 0), down = ask(0, 1),
               up = ask(0, -1);
    if (!here || !right || !left || !down || !up) continue;
    if (right->object != s.object || left->object != s.object || down->object != s.object ||
        up->object != s.object) {
      continue;
    }
    ASSERT_NEAR(here->u, s.u, 1e-9);
    const double period = s.object == 1 ? 2 : 1;
    const double size = std::abs(s.dudx) + std::abs(s.dvdx) + std::abs(s.dudy) + std::abs(s.dvdy);
    if (size > 0.5) continue;  // at limbs and near the horizon curvature wins over any step
    // Central differences err by a third derivative / 6 k^2: 1e-4 of the largest at the limbs.
    const double bound = 5e-4 * size;
    const auto du = [&](const auto& a, const auto& b) {
      const double d = b->u - a->u;
      return (s.object < 2 ? std::remainder(d, period) : d) * k / 2;
    };
    EXPECT_NEAR(s.dudx, du(left, right), bound) << s.x << " " << s.y;
    EXPECT_NEAR(s.dudy, du(up, down), bound) << s.x << " " << s.y;
    EXPECT_NEAR(s.dvdx, (right->v - left->v) * k / 2, bound) << s.x << " " << s.y;
    EXPECT_NEAR(s.dvdy, (down->v - up->v) * k / 2, bound) << s.x << " " << s.y;
    ++compared;
  }
  EXPECT_GT(compared, 60);
}

TEST_F(Samples, ChooseProbesByTheFootprintsTwoSides) {
  const std::string probes = "probes = 8\n";
  // 64 x 32 texels; texels a pixel: 64 * scale_u * pixel / 10 across, 32 * scale_v ... down.
  const auto ask = [&](const std::string& scale) {
    make(kMap + probes + kSquareOn + "uv_scale = " + scale + "\n" + kLight);
    return at(3, 2);
  };
  const double unit = 10 * 12 / 2.0;  // uv_scale / unit is du a pixel
  const auto scale = [&](double texels_u, double texels_v) {
    std::ostringstream text;
    text << std::setprecision(17) << '[' << texels_u * unit / 64 << ", " << texels_v * unit / 32
         << ']';
    return text.str();
  };
  SurfaceSample s = ask(scale(2, 6));
  EXPECT_EQ(s.probes_log2, 2) << "3 times as long as wide";
  EXPECT_NEAR(s.lod, std::log2(6.0 / 4), 1e-5);
  EXPECT_NEAR(s.axis_v, s.dvdy / 4, 1e-15);
  EXPECT_NEAR(s.axis_u, 0, 1e-15);
  s = ask(scale(100, 1.5));
  EXPECT_EQ(s.probes_log2, 3) << "limited";
  EXPECT_NEAR(s.lod, std::log2(100.0 / 8), 1e-5);
  EXPECT_NEAR(s.axis_u, s.dudx / 8, 1e-15);
  s = ask(scale(0.9, 0.001));
  EXPECT_EQ(s.probes_log2, 0) << "less than a texel either way";
  EXPECT_NEAR(s.lod, std::log2(0.9), 1e-5);
  s = ask(scale(4, 0.001));
  EXPECT_EQ(s.probes_log2, 2) << "a side of less than a texel counts as one";
}

TEST_F(Samples, StayFiniteAndLimitedAtPolesAndGrazingAngles) {
  const std::string image = "[image]\nsize = [65, 65]\n";
  // Straight onto the pole: the middle pixel's ray hits it exactly.
  make(kMap + "probes = 16\n" + image +
       "[camera]\nposition = [0, 0, 4]\nup = [0, 1, 0]\n[[object]]\nkind = \"sphere\"\ntexture = "
       "\"m\"\n" +
       kLight);
  EXPECT_EQ(at(32, 32).v, 0);
  const auto all_fine = [&](double turn) {
    for (const SurfaceSample& s : samples_) {
      for (const double d : {s.dudx, s.dvdx, s.dudy, s.dvdy, s.axis_u, s.axis_v}) {
        ASSERT_LE(std::abs(d), kLargestDerivative);
      }
      ASSERT_LE(std::abs(s.dudx), turn);
      ASSERT_LE(std::abs(s.dudy), turn);
      ASSERT_TRUE(std::isfinite(s.lod) && std::isfinite(s.u) && std::isfinite(s.v));
      ASSERT_LE(std::hypot(s.light[0], s.light[1]), 1 + 1e-12);
    }
  };
  all_fine(1);
  // A plane seen from so low that its horizon lies within a pixel of the middle.
  make(kMap + image + "[camera]\nposition = [0, -4, 0.000001]\ntarget = [0, 0, 0.000001]\n" +
       "[[object]]\nkind = \"plane\"\ntexture = \"m\"\norigin = [-1e6, 1e6, 0]\n" +
       "i = [2e6, 0, 0]\nj = [0, -2e6, 0]\nuv_scale = [1e6, 1e6]\n" + kLight);
  EXPECT_GT(samples_.size(), 65U * 30U);
  all_fine(kLargestDerivative);
}

}  // namespace
}  // namespace ptm::golden
