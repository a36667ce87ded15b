// Eq. 16-18 and what stands in for them where they have no answer; Eq. 19, derived.
#include "golden/effects/map_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "golden/effects/curvature_gain.h"
#include "golden/effects/touching_polynomial.h"

namespace ptm::golden {
namespace {

/// The greatest value over the closed disc, searched: 400 rings of 400 lights.
double greatest(const Coefficients& a) {
  double best = luminance(a, 0, 0);
  for (int i = 1; i <= 400; ++i) {
    for (int j = 0; j < 400; ++j) {
      const double angle = 2 * std::numbers::pi * j / 400, r = i / 400.0;
      best = std::max(best, luminance(a, r * std::cos(angle), r * std::sin(angle)));
    }
  }
  return best;
}

/// -(d^T M d) about (u, v) plus 10: the maximum is known.
Coefficients hill(double u, double v, double uu, double vv, double uv) {
  return {-uu,
          -vv,
          -uv,
          2 * uu * u + uv * v,
          2 * vv * v + uv * u,
          10 - uu * u * u - vv * v * v - uv * u * v};
}

Coefficients random_coefficients(std::mt19937& random, double curvature) {
  std::uniform_real_distribution<double> any(-1, 1);
  Coefficients a{};
  for (std::size_t k = 0; k < 6; ++k) a[k] = any(random) * (k < 3 ? curvature : 1);
  return a;
}

TEST(BrightestLight, IsWhereEquation16And17FindAMaximumInside) {
  for (const auto& [u, v] : {std::pair{0.3, -0.2}, {0.0, 0.0}, {-0.7, 0.7}, {0.999, 0.0}}) {
    const Peak peak = brightest_light(hill(u, v, 3, 2, 1.5));
    EXPECT_EQ(peak.kind, PeakKind::inside);
    EXPECT_NEAR(peak.light[0], u, 1e-12);
    EXPECT_NEAR(peak.light[1], v, 1e-12);
  }
}

TEST(BrightestLight, IsNowhereLessBrightThanAnyLightOfTheDisc) {
  std::mt19937 random(5);
  std::array<int, 4> kinds{};
  for (int n = 0; n < 300; ++n) {
    Coefficients a = random_coefficients(random, n % 3 == 0 ? 0.1 : 1);
    if (n % 2 == 0) a = hill(1.3 * a[3], 1.3 * a[4], 2 + a[0], 2 + a[1], a[2]);
    const Peak peak = brightest_light(a);
    ++kinds[static_cast<std::size_t>(peak.kind)];
    EXPECT_LE(std::hypot(peak.light[0], peak.light[1]), 1 + 1e-12);
    EXPECT_GE(luminance(a, peak.light[0], peak.light[1]), greatest(a) - 1e-9);
  }
  EXPECT_GT(kinds[0], 20);
  EXPECT_GT(kinds[1], 20);
}

TEST(BrightestLight, OfAMaximumBeyondTheDiscASaddleOrAMinimumLiesOnTheRim) {
  const Peak beyond = brightest_light(hill(3, 4, 1, 1, 0));
  EXPECT_EQ(beyond.kind, PeakKind::rim);
  EXPECT_NEAR(beyond.light[0], 0.6, 1e-9);
  EXPECT_NEAR(beyond.light[1], 0.8, 1e-9);
  const Peak saddle = brightest_light({1, -1, 0, 0, 0, 0});
  EXPECT_EQ(saddle.kind, PeakKind::rim);
  EXPECT_NEAR(std::abs(saddle.light[0]), 1, 1e-9);
  const Peak minimum = brightest_light({2, 1, 0, -0.1, 0, 0});
  EXPECT_EQ(minimum.kind, PeakKind::rim);
  EXPECT_NEAR(minimum.light[0], -1, 1e-9);
  const Peak slope = brightest_light({0, 0, 0, 0, -3, 7});
  EXPECT_EQ(slope.kind, PeakKind::rim);
  EXPECT_NEAR(slope.light[1], -1, 1e-9);
}

TEST(BrightestLight, OfARidgeIsItsPointNearestToTheZenith) {
  // -(0.6 u + 0.8 v - 0.5)^2: a line of maxima at right angles to (0.6, 0.8).
  const Peak peak = brightest_light({-0.36, -0.64, -0.96, 0.6, 0.8, -0.25});
  EXPECT_EQ(peak.kind, PeakKind::ridge);
  EXPECT_NEAR(peak.light[0], 0.3, 1e-9);
  EXPECT_NEAR(peak.light[1], 0.4, 1e-9);
  // The ridge of -(u - 2)^2 does not cross the disc.
  EXPECT_EQ(brightest_light({-1, 0, 0, 4, 0, -4}).kind, PeakKind::rim);
  // A ridge that rises is brightest at its upper end.
  const Peak rising = brightest_light({-1, 0, 0, 0, 0.5, 0});
  EXPECT_EQ(rising.kind, PeakKind::rim);
  EXPECT_NEAR(rising.light[1], 1, 1e-9);
}

TEST(BrightestLight, OfAFlatTexelIsTheZenith) {
  for (const Coefficients& a :
       {Coefficients{}, Coefficients{0, 0, 0, 0, 0, 99}, Coefficients{3, 3, 0, 0, 0, 0}}) {
    const Peak peak = brightest_light(a);
    EXPECT_EQ(peak.kind, PeakKind::flat);
    EXPECT_EQ(peak.light, (std::array<double, 2>{0, 0}));
    EXPECT_EQ(normal_of(a, peak), (std::array<double, 3>{0, 0, 1}));
  }
}

TEST(NormalOf, IsAUnitVectorForEveryTexelHoweverStrange) {
  std::vector<Coefficients> strange{{0, 0, 0, 0, 0, -5},         {0, 0, 0, 1e-300, 0, 0},
                                    {1e300, -1e300, 0, 1, 1, 1}, {-1e-300, -1e-300, 0, 1e300, 0, 0},
                                    {-1, -1, 2, 0, 0, 0},        {-1, -1, -2, 1e-9, -1e-9, 0},
                                    {0, 0, 1, 0, 0, 0},          {0, 0, 0, 1, 1, -1e9}};
  std::mt19937 random(6);
  for (int n = 0; n < 1000; ++n) strange.push_back(random_coefficients(random, 1));
  for (const Coefficients& a : strange) {
    const auto [u, v, w] = normal_of(a, brightest_light(a));
    EXPECT_NEAR(std::hypot(u, v, w), 1, 1e-9) << a[0] << " " << a[1] << " " << a[2];
    EXPECT_GE(w, 0);
  }
}

TEST(NormalOf, WithoutAMaximumHasTheValueAndSlopeUnderALightAtTheZenith) {
  // 50 N.L with N = (0.48, 0.6, 0.64), whose polynomial bends upwards.
  const Coefficients a{9, 9, 0, 24, 30, 32};
  const Peak peak = brightest_light(a);
  ASSERT_EQ(peak.kind, PeakKind::rim);
  const auto normal = normal_of(a, peak);
  EXPECT_NEAR(normal[0], 0.48, 1e-12);
  EXPECT_NEAR(normal[1], 0.6, 1e-12);
  EXPECT_NEAR(normal[2], 0.64, 1e-12);
}

TEST(MapNormals, AreThoseThatABumpMapWasMadeOfWhereItsPolynomialHasAMaximum) {
  // The fit's maximum lies at m / (2 |q| Nw), not at m: Eq. 16-18 give the polynomial's own normal.
  const NormalTable table(BumpDomain::hemisphere);
  const std::array<double, 3> n{0.3, 0.1, std::sqrt(0.9)};
  LoadedTexture map;
  map.width = map.height = 1;
  for (const double c : table.find(n)) map.coef.push_back(255 * c);
  map.color = {10, 20, 30};
  const auto found = map_normals(map);
  const double q = 15.0 / 16;
  EXPECT_EQ(found.without_maximum, 0U);
  EXPECT_NEAR(found.field.normals[0][0], 0.3 / (2 * q * n[2]), 2e-3);
  EXPECT_NEAR(found.field.normals[0][1], 0.1 / (2 * q * n[2]), 2e-3);
}

TEST(MapNormals, OfAnRgbMapAreThoseOfItsLuma) {
  LoadedTexture map;
  map.width = 2;
  map.height = 1;
  map.polynomials = 3;
  const Coefficients red = hill(0.5, 0, 1, 1, 0), green = hill(0, 0.5, 1, 1, 0);
  const Coefficients blue = hill(0, 0, 1, 1, 0);
  for (const Coefficients& a : {red, green, blue, Coefficients{}, Coefficients{}, Coefficients{}}) {
    map.coef.insert(map.coef.end(), a.begin(), a.end());
  }
  const MapNormals found = map_normals(map);
  EXPECT_NEAR(found.field.normals[0][0], 0.299 * 0.5, 1e-12);
  EXPECT_NEAR(found.field.normals[0][1], 0.587 * 0.5, 1e-12);
  EXPECT_EQ(found.without_maximum, 1U);
  EXPECT_EQ(without_maximum_note(map, 1).substr(0, 13), "1 of 2 texels");
}

TEST(CurvatureGain, KeepsTheMaximumWhereItIsAndAsBrightAsItIs) {
  const Coefficients a = hill(0.3, -0.4, 2, 1, 0.7);
  for (const double gain : {0.5, 1.0, 1.9, 1000.0}) {
    const Coefficients bent = with_curvature_gain(a, brightest_light(a), gain);
    const Peak peak = brightest_light(bent);
    EXPECT_EQ(peak.kind, PeakKind::inside);
    EXPECT_NEAR(peak.light[0], 0.3, 1e-9);
    EXPECT_NEAR(peak.light[1], -0.4, 1e-9);
    EXPECT_NEAR(luminance(bent, 0.3, -0.4), 10, 1e-9 * gain);
    EXPECT_DOUBLE_EQ(bent[0], gain * a[0]);
    EXPECT_DOUBLE_EQ(bent[1], gain * a[1]);
    EXPECT_DOUBLE_EQ(bent[2], gain * a[2]);
  }
  // Printed with lu0 and lv0 swapped in its row for a4', Eq. 19 would give another slope.
  const double g = 1.9, u = 0.3, v = -0.4;
  const Coefficients bent = with_curvature_gain(a, {{u, v}, PeakKind::inside}, g);
  EXPECT_NEAR(bent[3], (1 - g) * (2 * a[0] * u + a[2] * v) + a[3], 1e-12);
  EXPECT_NEAR(bent[4], (1 - g) * (2 * a[1] * v + a[2] * u) + a[4], 1e-12);
}

TEST(CurvatureGain, OfOneChangesNothingAndOfZeroLeavesThePlaneThatTouchesThePeak) {
  std::mt19937 random(7);
  for (int n = 0; n < 50; ++n) {
    const Coefficients a = random_coefficients(random, 1);
    EXPECT_EQ(with_curvature_gain(a, brightest_light(a), 1), a);
  }
  const Coefficients a = hill(0.3, -0.4, 2, 1, 0.7);
  const Coefficients plane = with_curvature_gain(a, brightest_light(a), 0);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(plane[k], 0, 1e-12);
  EXPECT_NEAR(plane[5], 10, 1e-12);
  // A maximum beyond the disc: the plane rises towards it.
  const Coefficients b = hill(3, 4, 1, 1, 0);
  const Coefficients tilted = with_curvature_gain(b, brightest_light(b), 0);
  EXPECT_NEAR(tilted[0], 0, 1e-12);
  EXPECT_GT(tilted[3], 0);
  EXPECT_NEAR(luminance(tilted, 0.6, 0.8), luminance(b, 0.6, 0.8), 1e-9);
}

TEST(CurvatureGain, AboveOneNeverBrightensAnyTexelAnywhereAndKeepsItsBrightestLight) {
  std::mt19937 random(8);
  for (int n = 0; n < 200; ++n) {
    const Coefficients a = random_coefficients(random, 1);
    const Peak peak = brightest_light(a);
    const double gain = n % 2 == 0 ? 2.5 : 1000;
    const Coefficients bent = with_curvature_gain(a, peak, gain);
    const double top = luminance(a, peak.light[0], peak.light[1]);
    EXPECT_NEAR(luminance(bent, peak.light[0], peak.light[1]), top, 1e-9 * gain);
    EXPECT_LE(greatest(bent), top + 1e-9 * gain);
  }
}

TEST(CurvatureGain, OfAMinimumAndOfAFlatTexelChangesNothing) {
  for (const Coefficients& a : {Coefficients{2, 1, 0.5, -0.1, 0, 3}, Coefficients{},
                                Coefficients{0, 0, 0, 0, 0, 9}, Coefficients{0, 0, 0, 1, 2, 9}}) {
    EXPECT_EQ(with_curvature_gain(a, brightest_light(a), 1000), a);
    EXPECT_EQ(with_curvature_gain(a, brightest_light(a), 0), a);
  }
}

TEST(TouchingPolynomial, HasTheValueSlopeAndCurvatureOfTheDotProductAtTheNormal) {
  for (const auto& [u, v] : {std::pair{0.0, 0.0}, {0.3, -0.2}, {-0.5, 0.6}}) {
    const double w = std::sqrt(1 - u * u - v * v);
    const Coefficients a = touching_polynomial({u, v, w});
    const auto dot = [&](double hu, double hv) {
      return hu * u + hv * v + std::sqrt(1 - hu * hu - hv * hv) * w;
    };
    EXPECT_NEAR(luminance(a, u, v), 1, 1e-12);
    // Third order: the difference falls with the cube of the step.
    for (const double angle : {0.0, 1.0, 2.5, 4.0}) {
      for (const double step : {0.02, 0.01}) {
        const double hu = u + step * std::cos(angle), hv = v + step * std::sin(angle);
        EXPECT_NEAR(luminance(a, hu, hv), dot(hu, hv), 6 * step * step * step);
      }
    }
  }
}

TEST(TouchingPolynomial, OfASteepNormalIsBoundedAndStillGreatestThere) {
  for (const auto& n : {std::array{0.96, 0.0, 0.28}, std::array{0.6, 0.8, 0.0}}) {
    const Coefficients a = touching_polynomial(n);
    for (const double c : a) EXPECT_LE(std::abs(c), 5.0 + 1e-12);
    EXPECT_LE(greatest(a), 1 + 1e-12);
    EXPECT_NEAR(luminance(a, n[0], n[1]), 1, 1e-12);
  }
}

}  // namespace
}  // namespace ptm::golden
