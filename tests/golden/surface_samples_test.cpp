#include "golden/scene/surface_samples.h"

#include <cmath>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>

#include "tests/golden/made_scene.h"

namespace ptm::golden {
namespace {

constexpr double kPi = std::numbers::pi;

const std::string kMap = "[[texture]]\nname = \"m\"\ngenerate = \"gradient\"\nsize = [64, 32]\n";

class Samples : public MadeScene {
 protected:
  void make(const std::string& text) {
    scene_ = read(text);
    textures_ = load_textures(scene_);
    samples_ = make_samples(scene_, textures_, 0);
  }
  /// The sample at a pixel; the pixel must be covered.
  [[nodiscard]] const SurfaceSample& at(int x, int y) const {
    for (const SurfaceSample& s : samples_) {
      if (s.x == x && s.y == y) return s;
    }
    throw std::out_of_range("no sample there");
  }

  UnitScene scene_;
  LoadedTextures textures_;
  std::vector<SurfaceSample> samples_;
};

const std::string kSquareOn =
    "[image]\nsize = [20, 12]\ntile = 8\n[camera]\northographic = true\nheight = 2\n"
    "[[object]]\nkind = \"plane\"\ntexture = \"m\"\norigin = [-5, 0, 5]\ni = [10, 0, 0]\n"
    "j = [0, 0, -10]\n";
const std::string kLight = "[[light]]\ndirection = [0, -1, 0]\n";

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

const std::string kThree = R"(
[image]
size = [96, 64]
[camera]
position = [0.5, -5, 2]
up = [0.2, 0.1, 1]
fov_degrees = 50
[[object]]
kind = "sphere"
texture = "m"
translate = [-1.2, 0, 0.3]
rotate = [20, 30, 40]
scale = [1, 1.5, 0.7]
[[object]]
kind = "cylinder"
texture = "m"
translate = [1.2, 0.2, 0]
rotate = [-15, 10, 0]
uv_scale = [2, -3]
[[object]]
kind = "plane"
texture = "m"
origin = [-30, 30, -1.3]
i = [60, 0, 0]
j = [0, -60, 0]
)";

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

TEST_F(Samples, PutTheLightIntoTheFrameOfTheTexture) {
  // v runs down the picture and lv up, so a light from above right is (+, +).
  make(kMap + kSquareOn + "[[light]]\ndirection = [0.6, -0.64, 0.48]\n");
  EXPECT_NEAR(at(5, 5).light[0], 0.6, 1e-12);
  EXPECT_NEAR(at(5, 5).light[1], 0.48, 1e-12);
  // A texture turned upside down and mirrored sees the same light from below left.
  make(kMap + kSquareOn + "uv_scale = [1, 1]\n[[light]]\ndirection = [0.6, 0.64, 0.48]\n");
  EXPECT_FALSE(at(5, 5).lit) << "from behind";
  const std::string turned =
      "[image]\nsize = [20, 12]\n[camera]\northographic = true\n[[object]]\nkind = \"plane\"\n"
      "texture = \"m\"\norigin = [5, 0, -5]\ni = [-10, 0, 0]\nj = [0, 0, 10]\n";
  make(kMap + turned + "[[light]]\ndirection = [0.6, -0.64, 0.48]\n");
  EXPECT_NEAR(at(5, 5).light[0], -0.6, 1e-12);
  EXPECT_NEAR(at(5, 5).light[1], -0.48, 1e-12);
  EXPECT_TRUE(at(5, 5).lit);
}

TEST_F(Samples, MirrorTheLightWithTheTextureAndWithTheSideThatIsSeen) {
  const std::string mirrored =
      "[image]\nsize = [20, 12]\n[camera]\northographic = true\n[[object]]\nkind = \"plane\"\n"
      "texture = \"m\"\norigin = [5, 0, 5]\ni = [-10, 0, 0]\nj = [0, 0, -10]\n";
  make(kMap + mirrored + "[[light]]\ndirection = [0.6, -0.64, 0.48]\n");
  EXPECT_NEAR(at(5, 5).light[0], -0.6, 1e-12);
  EXPECT_NEAR(at(5, 5).light[1], 0.48, 1e-12);
  EXPECT_TRUE(at(5, 5).lit);
  // A cylinder's inside, seen through the open front: u runs to the left there, v still down.
  make(kMap +
       "[image]\nsize = [33, 33]\n[[object]]\nkind = \"cylinder\"\ntexture = \"m\"\ntheta = "
       "[45, 135]\n[[light]]\ndirection = [0.6, -0.64, 0.48]\n");
  const SurfaceSample& s = at(16, 16);
  EXPECT_NEAR(s.u, 0.25, 1e-12);
  EXPECT_LT(s.dudx, 0);
  EXPECT_NEAR(s.light[0], -0.6, 1e-12);
  EXPECT_NEAR(s.light[1], 0.48, 1e-12);
  EXPECT_TRUE(s.lit);
}

TEST_F(Samples, OfASphereSeeALightOverTheirHeadsFromTheTextureTop) {
  make(kMap +
       "[image]\nsize = [33, 33]\n[[object]]\nkind = \"sphere\"\ntexture = \"m\"\n"
       "[[light]]\ndirection = [0.3, -0.5, 0.812403840]\n");
  const SurfaceSample& s = at(16, 16);  // (0, -1, 0), theta = 270 degrees
  EXPECT_NEAR(s.u, 0.75, 1e-12);
  EXPECT_NEAR(s.v, 0.5, 1e-12);
  EXPECT_NEAR(s.light[0], 0.3, 1e-6);
  EXPECT_NEAR(s.light[1], 0.8124, 1e-4);
  EXPECT_GT(at(20, 16).u, s.u) << "u runs to the right";
  EXPECT_GT(at(16, 20).v, s.v) << "v runs down";
}

TEST_F(Samples, TakeAPointLightFromWhereItStands) {
  make(kMap + kSquareOn + "[[light]]\nposition = [0.25, -1, 0.75]\n");
  const SurfaceSample& s = at(3, 2);
  const double pixel = 2.0 / 12;
  const Vec3 point((3.5 - 10) * pixel, 0, (6 - 2.5) * pixel);
  const Vec3 l = (Vec3(0.25, -1, 0.75) - point).normalized();
  EXPECT_NEAR(s.light[0], l.x(), 1e-12);
  EXPECT_NEAR(s.light[1], l.z(), 1e-12);
}

TEST_F(Samples, HandALocalLightOnAsItIs) {
  make(kMap + kThree + "[[light]]\ndirection = [-1.5, 0.25]\n");
  for (const SurfaceSample& s : samples_) {
    ASSERT_EQ(s.light, (std::array<double, 2>{-1.5, 0.25}));
    ASSERT_EQ(s.light_vertex, s.light);
    ASSERT_TRUE(s.lit);
  }
}

TEST_F(Samples, InterpolateLightExactlyAtCornersAndLinearlyBetween) {
  // One cell a turn of a quarter cylinder; its corners lie at theta 270 and 360 degrees.
  const std::string part =
      "[image]\nsize = [401, 9]\n[camera]\nposition = [3, -3, 0]\northographic = true\n"
      "height = 0.045\n[[object]]\nkind = \"cylinder\"\ntexture = \"m\"\ntheta = [270, 360]\n"
      "segments = [1, 1]\n";
  make(kMap + part + "[[light]]\ndirection = [0.3, -0.9, 0.1]\n");
  const Vec3 l = Vec3(0.3, -0.9, 0.1).normalized();
  const double first = l.x(), last = l.y();  // tangents (1, 0, 0) and (0, 1, 0)
  int checked = 0;
  for (const SurfaceSample& s : samples_) {
    const double part_of_cell = (s.u - 0.75) * 4;
    EXPECT_NEAR(s.light_vertex[0], std::lerp(first, last, part_of_cell), 1e-9);
    EXPECT_NEAR(s.light_vertex[1], l.z(), 1e-12);
    const double theta = 2 * kPi * s.u;
    EXPECT_NEAR(s.light[0], -std::sin(theta) * l.x() + std::cos(theta) * l.y(), 1e-9);
    ++checked;
  }
  EXPECT_GT(checked, 1000);
}

TEST_F(Samples, InterpolateLightMoreCloselyWithMoreSegments) {
  double before = 1e9;
  for (const char* segments : {"[8, 4]", "[16, 8]", "[32, 16]", "[64, 32]"}) {
    make(kMap +
         "[image]\nsize = [48, 48]\n[[object]]\nkind = \"sphere\"\ntexture = \"m\"\n"
         "segments = " +
         segments + "\n[[light]]\ndirection = [-1, -1, 1]\n");
    double worst = 0;
    for (const SurfaceSample& s : samples_) {
      worst = std::max({worst, std::abs(s.light[0] - s.light_vertex[0]),
                        std::abs(s.light[1] - s.light_vertex[1])});
    }
    EXPECT_LT(worst, before / 3) << "an error of second order falls to a quarter";
    before = worst;
  }
}

TEST_F(Samples, OfAMeshHaveTheLightOfItsVerticesNormals) {
  write("m.obj",
        "v -1 0 -1\nv 1 0 -1\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0.5 1\n"
        "vn -1 -1 0\nvn 1 -1 0\nvn 0 -1 0\nf 1/1/1 2/2/2 3/3/3\n");
  make(kMap +
       "[image]\nsize = [40, 40]\n[[object]]\nkind = \"mesh\"\nfile = \"m.obj\"\n"
       "texture = \"m\"\n[[light]]\ndirection = [0, -1, 0]\n");
  ASSERT_GT(samples_.size(), 100U);
  for (const SurfaceSample& s : samples_) {
    // Corner lights: the tangent leans back by 45 degrees to either side.
    const double half = std::sqrt(0.5);
    const double b2 = 1 - s.v, b1 = s.u - 0.5 * b2, b0 = 1 - b1 - b2;
    EXPECT_NEAR(s.light_vertex[0], half * (b0 - b1), 1e-9);
    EXPECT_NEAR(s.light_vertex[1], 0, 1e-9);
    EXPECT_TRUE(s.lit);
  }
}

TEST_F(Samples, SeeTheSameFrontWhicheverWayATriangleIsWound) {
  const auto light_of = [&](const std::string& face) {
    write("m.obj", "v -1 0 -1\nv 1 0 -1\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0.5 1\nvn 0 -1 0.5\n" + face);
    make(kMap +
         "[image]\nsize = [9, 9]\n[[object]]\nkind = \"mesh\"\nfile = \"m.obj\"\n"
         "texture = \"m\"\n[[light]]\ndirection = [0.3, -1, 0.2]\n");
    EXPECT_TRUE(at(4, 4).lit);
    return at(4, 4).light;
  };
  const auto one = light_of("f 1/1/1 2/2/1 3/3/1\n"), other = light_of("f 1/1/1 3/3/1 2/2/1\n");
  EXPECT_NEAR(one[0], other[0], 1e-12);
  EXPECT_NEAR(one[1], other[1], 1e-12);
}

}  // namespace
}  // namespace ptm::golden
