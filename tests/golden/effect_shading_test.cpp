// Golden's effects against their equations, written down again.
#include <algorithm>
#include <cmath>

#include "golden/render/texture_filter.h"
#include "tests/golden/made_effects.h"

namespace ptm::golden {
namespace {

TEST_F(Effects, SampleTheHalfVectorBetweenLightAndCamera) {
  // Seen square-on from infinity: V is the normal, and H halves the light's angle with it.
  prepare(kDark + kSquare + effect("half-vector") + "[[light]]\ndirection = [1, -1, 0]\n");
  const double half = std::sin(kPi / 8);
  EXPECT_NEAR(at(3, 4).half[0], half, 1e-12);
  EXPECT_NEAR(at(3, 4).half[1], 0, 1e-12);
  EXPECT_NEAR(at(3, 4).half_vertex[0], half, 1e-12);
  // A local light has the same third part as if it stood in the world.
  prepare(kDark + kSquare + effect("half-vector") + local(std::sqrt(0.5), 0));
  EXPECT_NEAR(at(3, 4).half[0], half, 1e-6);
}

TEST_F(Effects, SampleTheHalfVectorOfAPerspectiveViewAndAPointLight) {
  prepare(kDark +
          "[image]\nsize = [16, 16]\n[camera]\nposition = [0.5, -4, 1]\n[[object]]\n"
          "kind = \"sphere\"\ntexture = \"m\"\n" +
          effect("half-vector") + "[[light]]\nposition = [2, -3, 2]\n");
  for (const SurfaceSample& s : samples_) {
    // The sphere's own frame: theta = 2 pi u, phi = pi v.
    const double theta = 2 * kPi * s.u, phi = kPi * s.v;
    const Vec3 n(std::cos(theta) * std::sin(phi), std::sin(theta) * std::sin(phi), std::cos(phi));
    const Vec3 east(-std::sin(theta), std::cos(theta), 0), north = n.cross(east);
    const Vec3 h =
        ((Vec3(2, -3, 2) - n).normalized() + (Vec3(0.5, -4, 1) - n).normalized()).normalized();
    EXPECT_NEAR(s.half[0], h.dot(east), 1e-9);
    EXPECT_NEAR(s.half[1], h.dot(north), 1e-9);
    EXPECT_NEAR(s.half_vertex[0], s.half[0], 0.02) << "32 x 16 cells";
    EXPECT_LE(std::hypot(s.half[0], s.half[1]), 1 + 1e-12);
  }
}

TEST_F(Effects, HaveNoHalfVectorWhereNoneAsksAndZeroWhereThereIsNone) {
  prepare(kDark + kSquare + "[[light]]\ndirection = [1, -1, 0]\n");
  for (const SurfaceSample& s : samples_) EXPECT_EQ(s.half, (std::array<double, 2>{}));
  // The light stands behind, right opposite the camera.
  prepare(kDark + kSquare + effect("half-vector") + "[[light]]\ndirection = [0, 1, 0]\n");
  for (const SurfaceSample& s : samples_) {
    EXPECT_EQ(s.half, (std::array<double, 2>{}));
    EXPECT_FALSE(s.lit);
    EXPECT_EQ(added(s), (Rgb{})) << "light behind the surface adds nothing";
  }
  // Rounding leaves a sum of no length to speak of, which has no direction either.
  prepare(kDark +
          "[image]\nsize = [9, 9]\n[camera]\northographic = true\nposition = [1.1, -3.1, 0.7]\n"
          "[[object]]\nkind = \"plane\"\ntexture = \"m\"\nrotate = [10, 20, 30]\n" +
          effect("half-vector") + "[[light]]\ndirection = [-1.1, 3.1, -0.7]\n");
  for (const SurfaceSample& s : samples_) EXPECT_EQ(s.half, (std::array<double, 2>{}));
  // Grazing on both sides.
  prepare(kDark + kSquare + effect("half-vector") + "[[light]]\ndirection = [1, 0, 0]\n");
  for (const SurfaceSample& s : samples_) {
    EXPECT_NEAR(s.half[0], std::sqrt(0.5), 1e-12);
    EXPECT_TRUE(std::isfinite(shaded(s)[0]));
  }
}

TEST_F(Effects, HalveTheAngleToTheHorizonWhereTheLightLiesBeyondTheDisc) {
  // V is the normal, so H leans 45 degrees whatever the length of (lu, lv).
  for (const double length : {1.0, 1.25, 1.9, 50.0}) {
    prepare(kDark + kSquare + effect("half-vector") + local(0.6 * length, -0.8 * length));
    for (const SurfaceSample& s : samples_) {
      EXPECT_NEAR(s.half[0], 0.6 * std::sqrt(0.5), 1e-7) << length;
      EXPECT_NEAR(s.half[1], -0.8 * std::sqrt(0.5), 1e-7) << length;
      EXPECT_NEAR(s.half_vertex[1], s.half[1], 1e-12);
      EXPECT_NEAR(s.light[0], 0.6 * length, 1e-5) << "the map is lit from where the scene says";
    }
  }
}

TEST_F(Effects, AddTheSpecularTermOfTheMapsOwnPolynomial) {
  prepare(kStuds + kSquare + effect("half-vector", "ks = 0.3\nexponent = 7\n") + local(0.5, 0.3));
  int bright = 0;
  for (const SurfaceSample& s : samples_) {
    const auto x = static_cast<std::size_t>(point_texel(s.u, 24, WrapMode::clamp));
    const auto y = static_cast<std::size_t>(point_texel(s.v, 24, WrapMode::clamp));
    const double* a = &textures_[0].coef[(y * 24 + x) * 6];
    const auto [u, v] = s.half;
    const double dot = std::clamp(
        (a[0] * u * u + a[1] * v * v + a[2] * u * v + a[3] * u + a[4] * v + a[5]) / 255, 0.0, 1.0);
    const double expected = 0.3 * 255 * std::pow(dot, 7);
    const Rgb before = UnitRenderer(scene_, textures_).shade(s, s.light);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(shaded(s)[c], std::min(255.0, before[c] + expected), 1e-9);
    }
    bright += expected > 10;
  }
  EXPECT_GT(bright, 10);
}

TEST_F(Effects, TakeTheSpecularTermAtExponents1And255) {
  for (const int n : {1, 255}) {
    prepare(kDark + kSquare +
            effect("specular-enhancement", "ks = 0.5\nexponent = " + std::to_string(n) + "\n") +
            local(0.6, 0));
    const SurfaceSample& s = at(5, 5);
    // Flat: N.H = 1 - r^2 / 2 to second order, which is the polynomial.
    const double r2 = s.half[0] * s.half[0] + s.half[1] * s.half[1];
    EXPECT_NEAR(added(s)[1], 127.5 * std::pow(1 - r2 / 2, n), 1e-9);
    EXPECT_EQ(extras_[0].table[255], 255);
    EXPECT_EQ(extras_[0].table[0], 0);
    EXPECT_NEAR(extras_[0].table[128], 255 * std::pow(128.0 / 255, n), 1e-12);
  }
}

TEST_F(Effects, EnhanceWithTheNormalsOfTheMap) {
  const std::string tablet =
      "[[texture]]\nname = \"m\"\ngenerate = \"tablet\"\nsize = [24, 24]\nfilter = \"point\"\n";
  prepare(tablet + kSquare + effect("specular-enhancement", "ks = 0.5\nexponent = 20\n") +
          local(0.4, 0.4));
  ASSERT_EQ(extras_[0].sets.size(), 1U);
  EXPECT_EQ(extras_[0].passes.size(), 1U);
  int near = 0, counted = 0;
  for (const SurfaceSample& s : samples_) {
    const auto x = static_cast<std::size_t>(point_texel(s.u, 24, WrapMode::clamp));
    const auto y = static_cast<std::size_t>(point_texel(s.v, 24, WrapMode::clamp));
    // Eq. 16-18 and Eq. 8 by themselves.
    const double* a = &textures_[0].coef[(y * 24 + x) * 6];
    const double d = 4 * a[0] * a[1] - a[2] * a[2];
    const double u = (a[2] * a[4] - 2 * a[1] * a[3]) / d, v = (a[2] * a[3] - 2 * a[0] * a[4]) / d;
    if (!(d > 0) || !(a[0] < 0) || u * u + v * v > 0.5) continue;
    const auto [hu, hv] = s.half;
    const double dot =
        u * hu + v * hv + std::sqrt(1 - u * u - v * v) * std::sqrt(1 - hu * hu - hv * hv);
    ++counted;
    near += std::abs(added(s)[0] - 127.5 * std::pow(std::max(0.0, dot), 20)) < 8;
  }
  EXPECT_GT(counted, 100);
  EXPECT_GT(near, 0.9 * counted) << "the touching polynomial is near N.H where it counts";
}

TEST_F(Effects, ExtrapolateTheLightButNotTheHalfVector) {
  const std::string base = kDark + kSquare + effect("half-vector");
  prepare(base + "[[light]]\ndirection = [0.6, -0.64, 0.48]\n");
  const SurfaceSample before = at(4, 4);
  prepare(base + effect("light-extrapolation", "gain = 2.5\n") +
          "[[light]]\ndirection = [0.6, -0.64, 0.48]\n");
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(at(4, 4).light[k], 2.5 * before.light[k], 1e-12);
    EXPECT_NEAR(at(4, 4).light_vertex[k], 2.5 * before.light_vertex[k], 1e-12);
    EXPECT_EQ(at(4, 4).half[k], before.half[k]);
  }
  EXPECT_TRUE(at(4, 4).lit);
}

TEST_F(Effects, GiveAMapOfFocusOrTimeTheCoordinatesOfItsFrame) {
  const std::string stack =
      "[[texture]]\nname = \"m\"\ngenerate = \"tide\"\nsize = [16, 12]\nfilter = \"point\"\n";
  for (const char* kind : {"focus", "time"}) {
    const std::string text = stack + kSquare +
                             effect(kind, "coordinates = [[-1, 0], [0.5, 0.25]]\n") +
                             "[[light]]\ndirection = [0, 1, 0]\n" + kLight;
    prepare(text, 1);
    EXPECT_EQ(at(3, 3).light, (std::array<double, 2>{0.5, 0.25}));
    prepare(text, 0);
    EXPECT_EQ(at(3, 3).light, (std::array<double, 2>{-1, 0}));
    EXPECT_EQ(at(3, 3).light_vertex, (std::array<double, 2>{-1, 0}));
    EXPECT_TRUE(at(3, 3).lit) << "the scene's light is behind, which is nothing to it";
    const SurfaceSample& s = at(3, 3);
    const auto t = static_cast<std::size_t>(s.v * 12) * 16 + static_cast<std::size_t>(s.u * 16);
    for (std::size_t c = 0; c < 3; ++c) {
      const double* a = &textures_[0].coef[(t * 3 + c) * 6];
      EXPECT_NEAR(shaded(s)[c], std::clamp(a[0] - a[3] + a[5], 0.0, 255.0), 1e-9);
    }
  }
}

TEST_F(Effects, PaintNormals) {
  prepare("[[texture]]\nname = \"m\"\ngenerate = \"studs\"\nsize = [24, 24]\nfilter = \"point\"\n" +
          kSquare + effect("normals") + kLight);
  SurfaceSample ground = at(0, 0);
  ground.u = ground.v = 0.5 / 24;  // between the studs
  const Rgb flat = shaded(ground);
  EXPECT_NEAR(flat[0], 127.5, 1e-9);
  EXPECT_NEAR(flat[1], 127.5, 1e-9);
  EXPECT_NEAR(flat[2], 255, 1e-9);
  double left = 255, right = 0;
  for (const SurfaceSample& s : samples_) {
    left = std::min(left, shaded(s)[0]);
    right = std::max(right, shaded(s)[0]);
  }
  EXPECT_LT(left, 100);
  EXPECT_GT(right, 155);
}

TEST_F(Effects, FilterTheAddendAsTheyFilterTheMap) {
  const std::string kMip =
      "[[texture]]\nname = \"m\"\ngenerate = \"studs\"\nsize = [24, 24]\nfilter = \"";
  const std::string terms = kSquare + effect("half-vector", "ks = 0.1\nexponent = 9\n");
  prepare(kMip + "bilinear\"\n" + terms + local(0.5, 0.3));
  // Halfway between two texels' centres: the mean of what each adds.
  SurfaceSample between = at(3, 3);
  between.u = 6.0 / 24;
  between.v = 5.5 / 24;
  SurfaceSample one = between, other = between;
  one.u = 5.5 / 24;
  other.u = 6.5 / 24;
  EXPECT_NEAR(added(between)[2], (added(one)[2] + added(other)[2]) / 2, 1e-9);
  EXPECT_GT(std::abs(added(one)[2] - added(other)[2]), 1);
  // A level down, each texel's polynomial is the mean of four (Eq. 14), its power is taken then.
  prepare(kMip + "point-nearest-mip\"\n" + terms + local(0.5, 0.3));
  SurfaceSample below = between;
  below.lod = 1;
  below.u = 6.5 / 24;
  below.v = 8.5 / 24;
  double mean = 0;
  for (const std::size_t t : {198U, 199U, 222U, 223U}) {  // columns 6, 7 of rows 8, 9
    Coefficients a{};
    std::copy_n(&textures_[0].coef[t * 6], 6, a.begin());
    mean += luminance(a, below.half[0], below.half[1]) / 4;
  }
  EXPECT_NEAR(added(below)[2], 0.1 * 255 * std::pow(std::clamp(mean / 255, 0.0, 1.0), 9), 1e-9);
}

TEST_F(Effects, ComeToTheAreaAverageToo) {
  prepare(kStuds + kSquare + effect("half-vector", "ks = 0.4\nexponent = 9\n") + local(0.5, 0.3));
  const UnitRenderer renderer(scene_, textures_, extras_), plain(scene_, textures_);
  const SurfaceSample& s = at(3, 3);
  // A pixel covers 2 x 2 texels; their lit and added levels are averaged.
  double expected = 0;
  for (const double dy : {-0.5, 0.5}) {
    for (const double dx : {-0.5, 0.5}) {
      SurfaceSample part = s;
      part.u += dx / 24;
      part.v += dy / 24;
      const Rgb with = renderer.shade(part, s.light), without = plain.shade(part, s.light);
      ASSERT_LT(with[2], 255);
      expected += (with[2] - without[2]) / 4;
    }
  }
  const Rgb with = renderer.area_average(s, s.light, s.half);
  const Rgb without = plain.area_average(s, s.light, s.half);
  EXPECT_NEAR(with[2] - without[2], expected, 1e-6);
}

TEST_F(Effects, NeverLeaveTheLevelsWhateverTheScene) {
  const std::string noise =
      "[[texture]]\nname = \"m\"\ngenerate = \"noise\"\nsize = [16, 16]\nfilter = \"trilinear\"\n"
      "[[texture]]\nname = \"g\"\ngenerate = \"noise\"\nkind = \"rgb\"\nseed = 2\n"
      "size = [16, 16]\n";
  const std::string object =
      "[image]\nsize = [24, 24]\n[[object]]\nkind = \"sphere\"\ntexture = \"m\"\n";
  for (const std::string keys : {"0", "1000"}) {
    prepare(noise + object + effect("specular-enhancement", "ks = 1.99\nexponent = 255\n") +
            effect("modulated-specular", "map = \"g\"\n") + effect("fresnel") +
            effect("anisotropic", "power = 8\n") + effect("off-specular") +
            effect("light-extrapolation", "gain = 1000\n") +
            effect("diffuse-gain", "gain = " + keys + "\n") +
            "[[light]]\ndirection = [1, -0.2, 1]\n");
    for (const SurfaceSample& s : samples_) {
      for (const double level : shaded(s)) {
        ASSERT_TRUE(level >= 0 && level <= 255) << level;
      }
    }
  }
}

}  // namespace
}  // namespace ptm::golden
