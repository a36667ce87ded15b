// Light in the samples' own frames, per pixel and per vertex.
#include <algorithm>
#include <cmath>

#include "tests/golden/made_samples.h"

namespace ptm::golden {
namespace {

constexpr double kPi = std::numbers::pi;

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
