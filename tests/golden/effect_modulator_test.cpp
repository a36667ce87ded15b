// What the specular term is multiplied by (section 3.7), against the equations written down again.
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "golden/effects/reflectance.h"
#include "tests/golden/made_effects.h"

namespace ptm::golden {
namespace {

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
                           "filter = \"point\"\n[[texture]]\nname = \"g\"\ngenerate = \"gloss\"\n"
                           "size = [16, 16]\nfilter = \"point\"\n" +
                           kSquare + effect("specular-enhancement", "exponent = 1\n");
  prepare(base + local(0.3, 0.5));
  const double plain = added(at(7, 7))[0];
  prepare(base + effect("modulated-specular", "map = \"g\"\n") +
          effect("off-specular", "facing = 0.5\n") + local(0.3, 0.5));
  EXPECT_EQ(extras_[0].sets.size(), 2U);
  EXPECT_LT(extras_[0].residual.max, 1e-9) << "a constant times a polynomial is one";
  for (const SurfaceSample& s : samples_) {
    const auto x = static_cast<std::size_t>(s.u * 16), y = static_cast<std::size_t>(s.v * 16);
    const double gloss = textures_[1].color[(y * 16 + x) * 3] / 255.0;
    EXPECT_NEAR(added(s)[0], plain * gloss * (0.5 + 0.5 * 0.34), 1e-9);
  }
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

TEST_F(Effects, FitEveryTexelsProductByItself) {
  // Not square, so that a row is no column. A gray factor of each texel times a coloured one of
  // all.
  const std::string base =
      "[[texture]]\nname = \"m\"\ngenerate = \"metal\"\nsize = [24, 10]\n"
      "[[texture]]\nname = \"g\"\ngenerate = \"gloss\"\nsize = [24, 10]\n" +
      kSquare + effect("specular-enhancement");
  prepare(base + effect("fresnel") + local(0.3, 0.5));
  const std::vector<std::vector<double>> gold = extras_[0].sets;
  prepare(base + effect("modulated-specular", "map = \"g\"\n") + effect("fresnel") +
          local(0.3, 0.5));
  ASSERT_EQ(extras_[0].sets.size(), 4U);
  double least = 255, most = 0;
  for (std::size_t t = 0; t < 240; ++t) {
    const double gloss = textures_[1].color[t * 3] * textures_[1].coef[t * 6 + 5] / 255;
    least = std::min(least, gloss);
    most = std::max(most, gloss);
    for (std::size_t s = 1; s < 4; ++s) {
      for (std::size_t k = t * 6; k < t * 6 + 6; ++k) {
        ASSERT_NEAR(extras_[0].sets[s][k], gold[s][k] * gloss / 255, 1e-9) << s << " " << t;
      }
    }
  }
  EXPECT_GT(most, least + 50) << "texels differ";
}

TEST_F(Effects, FitTheSameProductOnOneThreadAndOnMany) {
  const std::string text = "[[texture]]\nname = \"m\"\ngenerate = \"metal\"\nsize = [48, 64]\n" +
                           kSquare + effect("specular-enhancement") + effect("fresnel") +
                           effect("anisotropic") + local(0.3, 0.5);
  // More than the machine may have.
  const tbb::global_control most(tbb::global_control::max_allowed_parallelism, 8);
  tbb::task_arena(8).execute([&] { prepare(text); });
  const DrawExtras many = extras_[0];
  tbb::task_arena(1).execute([&] { prepare(text); });
  EXPECT_EQ(extras_[0].sets, many.sets);
  EXPECT_EQ(extras_[0].residual.rms, many.residual.rms);
  EXPECT_EQ(extras_[0].residual.max, many.residual.max);
}

}  // namespace
}  // namespace ptm::golden
