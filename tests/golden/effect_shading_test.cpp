// Golden's effects against their equations, written down again.
#include <algorithm>
#include <cmath>
#include <complex>

#include "golden/bump/bump_map.h"
#include "golden/effects/effect.h"
#include "golden/effects/reflectance.h"
#include "golden/render/unit_picture.h"
#include "tests/golden/made_samples.h"

namespace ptm::golden {
namespace {

class Effects : public Samples {
 protected:
  void prepare(const std::string& text, int frame = 0) {
    scene_ = read(text);
    textures_ = load_textures(scene_);
    extras_ = prepare_effects(scene_, textures_);
    samples_ = make_samples(scene_, textures_, frame);
  }
  [[nodiscard]] Rgb shaded(const SurfaceSample& sample) const {
    return UnitRenderer(scene_, textures_, extras_).shade(sample, sample.light);
  }
  /// What the effects add: against the same scene shaded without extras.
  [[nodiscard]] Rgb added(const SurfaceSample& sample) const {
    const Rgb with = shaded(sample);
    const Rgb without = UnitRenderer(scene_, textures_).shade(sample, sample.light);
    return {with[0] - without[0], with[1] - without[1], with[2] - without[2]};
  }
  std::vector<DrawExtras> extras_;
};

constexpr double kPi = std::numbers::pi;
const std::string kDark = "[[texture]]\nname = \"m\"\ngenerate = \"metal\"\nsize = [16, 16]\n";
const std::string kStuds =
    "[[texture]]\nname = \"m\"\ngenerate = \"studs\"\nsize = [24, 24]\nfilter = \"point\"\n";
const std::string kSquare =
    "[image]\nsize = [12, 12]\n[camera]\northographic = true\nheight = 2\n"
    "[[object]]\nkind = \"plane\"\ntexture = \"m\"\n";

std::string effect(const std::string& kind, const std::string& keys = "") {
  return "[[object.effect]]\nkind = \"" + kind + "\"\n" + keys;
}
std::string local(double lu, double lv) {
  return "[[light]]\ndirection = [" + std::to_string(lu) + ", " + std::to_string(lv) + "]\n";
}

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
  // Grazing on both sides.
  prepare(kDark + kSquare + effect("half-vector") + "[[light]]\ndirection = [1, 0, 0]\n");
  for (const SurfaceSample& s : samples_) {
    EXPECT_NEAR(s.half[0], std::sqrt(0.5), 1e-12);
    EXPECT_TRUE(std::isfinite(shaded(s)[0]));
  }
  // Beyond the disc the third part is 0, and H is a direction still.
  prepare(kDark + kSquare + effect("half-vector") + local(3, 4));
  for (const SurfaceSample& s : samples_) EXPECT_LE(std::hypot(s.half[0], s.half[1]), 1 + 1e-12);
}

TEST_F(Effects, AddTheSpecularTermOfTheMapsOwnPolynomial) {
  prepare(kStuds + kSquare + effect("half-vector", "ks = 0.3\nexponent = 7\n") + local(0.5, 0.3));
  int bright = 0;
  for (const SurfaceSample& s : samples_) {
    const std::size_t x = static_cast<std::size_t>(s.u * 24),
                      y = static_cast<std::size_t>(s.v * 24);
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
    const std::size_t x = static_cast<std::size_t>(s.u * 24),
                      y = static_cast<std::size_t>(s.v * 24);
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

TEST_F(Effects, ModulateWithAnotherMapPerChannel) {
  const std::string rgb =
      "[[texture]]\nname = \"g\"\ngenerate = \"studs\"\nkind = \"rgb\"\nsize = [16, 16]\n"
      "filter = \"point\"\n";
  const std::string base = kDark + "filter = \"point\"\n" + rgb + kSquare +
                           effect("specular-enhancement", "ks = 0.9\nexponent = 3\n");
  prepare(base + local(0.3, 0.1));
  std::vector<Rgb> plain;
  for (const SurfaceSample& s : samples_) plain.push_back(added(s));
  prepare(base + effect("modulated-specular", "map = \"g\"\n") + local(0.3, 0.1));
  ASSERT_EQ(extras_[0].sets.size(), 4U);
  EXPECT_EQ(extras_[0].argument, 1U);
  EXPECT_EQ(extras_[0].residual.max, 0);
  for (std::size_t n = 0; n < samples_.size(); ++n) {
    const SurfaceSample& s = samples_[n];
    const auto x = static_cast<std::size_t>(s.u * 16), y = static_cast<std::size_t>(s.v * 16);
    for (std::size_t c = 0; c < 3; ++c) {
      Coefficients a{};
      std::copy_n(&textures_[1].coef[((y * 16 + x) * 3 + c) * 6], 6, a.begin());
      const double gloss = std::clamp(luminance(a, s.light[0], s.light[1]), 0.0, 255.0) / 255;
      EXPECT_NEAR(added(s)[c], plain[n][c] * gloss, 1e-9);
    }
  }
}

TEST_F(Effects, ModulateWithOneSetWhereTheOtherMapIsGray) {
  prepare(kDark + "[[texture]]\nname = \"g\"\ngenerate = \"gloss\"\nsize = [16, 16]\n" + kSquare +
          effect("half-vector") + effect("modulated-specular", "map = \"g\"\n") + local(0.3, 0.1));
  EXPECT_EQ(extras_[0].sets.size(), 1U);
  EXPECT_EQ(extras_[0].argument, 0U);
  ASSERT_EQ(extras_[0].passes.size(), 2U);
  EXPECT_EQ(extras_[0].passes[0].set, 0);
  EXPECT_TRUE(extras_[0].passes[0].half);
  EXPECT_EQ(extras_[0].passes[1].set, 1);
  EXPECT_FALSE(extras_[0].passes[1].half);
  for (std::size_t t = 0; t < 256; ++t) {
    EXPECT_EQ(extras_[0].sets[0][t * 6 + 3], 0) << "a gloss map is the same under every light";
  }
}

TEST_F(Effects, RiseTowardsGrazingOffSpecular) {
  const std::string base = kDark + kSquare + effect("specular-enhancement", "exponent = 1\n");
  for (const double lu : {0.0, 0.5, 0.9}) {
    prepare(base + local(lu, 0));
    const double plain = added(at(5, 5))[0];
    prepare(base + effect("off-specular", "facing = 0.25\ngrazing = 0.75\n") + local(lu, 0));
    EXPECT_NEAR(added(at(5, 5))[0], plain * (0.25 + 0.5 * lu * lu), 1e-9);
    EXPECT_EQ(extras_[0].residual.max, 0);
  }
}

/// Fresnel by the amplitudes themselves, in complex numbers.
double reflected(double cosine, double n, double k) {
  const std::complex<double> index(n, k);
  const double sine2 = 1 - cosine * cosine;
  const std::complex<double> inner = std::sqrt(1.0 - sine2 / (index * index));
  const auto across = (cosine - index * inner) / (cosine + index * inner);
  const auto along = (index * cosine - inner) / (index * cosine + inner);
  return (std::norm(across) + std::norm(along)) / 2;
}

TEST(Reflectance, IsFresnelsForDielectricsAndMetalsAtEveryAngle) {
  for (const auto& [n, k] :
       {std::pair{1.5, 0.0}, {1.0, 0.0}, {2.4, 0.0}, {0.21, 3.272}, {1.38, 1.914}, {0.05, 10.0}}) {
    for (int i = 1; i <= 100; ++i) {
      EXPECT_NEAR(reflectance(i / 100.0, n, k), reflected(i / 100.0, n, k), 1e-12) << n << " " << k;
    }
    EXPECT_NEAR(reflectance(0, n, k), 1, 1e-12);
  }
  EXPECT_NEAR(reflectance(1, 1.5, 0), 0.04, 1e-12);
  EXPECT_NEAR(reflectance(std::cos(std::atan(1.5)), 1.5, 0), 0.5 * std::pow(5.0 / 13, 2), 1e-12)
      << "at Brewster's angle only one polarisation is reflected";
}

TEST_F(Effects, ReflectAsFresnelSaysWithinTheFitsResidual) {
  const std::string base = kDark + kSquare + effect("specular-enhancement", "exponent = 1\n");
  for (const double lu : {0.0, 0.4, 0.7}) {
    prepare(base + local(lu, 0));
    const double plain = added(at(5, 5))[0];
    prepare(base + effect("fresnel") + local(lu, 0));
    EXPECT_EQ(extras_[0].argument, 1U);
    ASSERT_EQ(extras_[0].sets.size(), 4U);
    EXPECT_GT(extras_[0].residual.rms, 0);
    EXPECT_LT(extras_[0].residual.rms, 0.03);
    const double w = std::sqrt(1 - lu * lu);
    const Rgb gold{reflected(w, 0.21, 3.272), reflected(w, 0.43, 2.455), reflected(w, 1.38, 1.914)};
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(added(at(5, 5))[c] / plain, gold[c], extras_[0].residual.max);
    }
    prepare(base + effect("fresnel", "ior = 1.5\n") + local(lu, 0));
    EXPECT_EQ(extras_[0].argument, 0U);
    EXPECT_NEAR(added(at(5, 5))[0] / plain, reflected(w, 1.5, 0), extras_[0].residual.max);
  }
}

TEST_F(Effects, ProjectTheLightOnTheNormalPlaneOfTheGrooves) {
  const std::string base =
      kDark + "filter = \"point\"\n" + kSquare + effect("specular-enhancement", "exponent = 1\n");
  prepare(base + local(0.8, 0.1));
  const double plain = added(at(5, 5))[0];
  for (const int power : {1, 2}) {
    const std::string keys = "power = " + std::to_string(power) + "\n";
    prepare(base + effect("anisotropic", keys) + local(0.8, 0.1));
    EXPECT_EQ(extras_[0].residual.max == 0, power == 2) << "the square is a polynomial itself";
    for (const SurfaceSample& s : samples_) {
      // Rings about the middle of the texel that the sample meets.
      const double x = (std::floor(s.u * 16) + 0.5) / 16 - 0.5;
      const double y = 0.5 - (std::floor(s.v * 16) + 0.5) / 16;
      const Vec3 groove = Vec3(-y, x, 0).normalized();
      const Vec3 l(0.8, 0.1, std::sqrt(1 - 0.65));
      const double magnitude = (l - l.dot(groove) * groove).norm();
      EXPECT_NEAR(added(s)[0] / plain, std::pow(magnitude, power), extras_[0].residual.max + 1e-9);
    }
    prepare(base + effect("anisotropic", keys + "pattern = \"linear\"\nangle = 90\n") +
            local(0.8, 0.1));
    EXPECT_NEAR(added(at(2, 3))[0] / plain, std::pow(std::sqrt(1 - 0.01), power),
                extras_[0].residual.max + 1e-9);
  }
}

TEST_F(Effects, StoreTheProductOfSeveralModulatorsAsOne) {
  const std::string base = kDark +
                           "[[texture]]\nname = \"g\"\ngenerate = \"gloss\"\nsize = [16, 16]\n" +
                           kSquare + effect("specular-enhancement", "exponent = 1\n");
  prepare(base + local(0.3, 0.5));
  const double plain = added(at(7, 7))[0];
  prepare(base + effect("modulated-specular", "map = \"g\"\n") +
          effect("off-specular", "facing = 0.5\n") + local(0.3, 0.5));
  EXPECT_EQ(extras_[0].sets.size(), 2U);
  EXPECT_LT(extras_[0].residual.max, 1e-9) << "a constant times a polynomial is one";
  prepare(base + effect("modulated-specular", "map = \"g\"\n") + effect("fresnel") +
          effect("off-specular") + effect("anisotropic") + local(0.3, 0.5));
  EXPECT_EQ(extras_[0].sets.size(), 4U);
  ASSERT_EQ(extras_[0].notes.size(), 1U);
  EXPECT_NE(extras_[0].notes[0].find("off by"), std::string::npos);
  const SurfaceSample& s = at(7, 7);
  EXPECT_GT(plain, 0);
  for (const double channel : added(s)) {
    EXPECT_GE(channel, 0);
    EXPECT_LE(channel, plain);
  }
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
