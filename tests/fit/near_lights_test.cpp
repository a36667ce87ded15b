// Lights near the object: the fit of photographs that the test renders itself.
#include "golden/fit/near_lights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "golden/fit/fit_quality.h"
#include "golden/fit/fit_tile.h"

namespace ptm::golden {
namespace {

using Vector = std::array<double, 3>;
using Polynomial = Eigen::Matrix<double, 6, 1>;

constexpr int kWide = 12, kHigh = 8;
constexpr std::size_t kTexels = kWide * kHigh;

/// Lamps on a dome, three rings and the zenith, not all at the same distance.
std::vector<Vector> dome(double radius) {
  std::vector<Vector> lights{{0, 0, radius}};
  for (int i = 0; i < 30; ++i) {
    const double elevation = (20 + 25 * (i % 3)) * std::numbers::pi / 180;
    const double angle = 2 * std::numbers::pi * i / 30, away = radius * (1 + 0.01 * (i % 5));
    lights.push_back({away * std::cos(elevation) * std::cos(angle),
                      away * std::cos(elevation) * std::sin(angle), away * std::sin(elevation)});
  }
  return lights;
}

std::vector<Vector> directions_of(const std::vector<Vector>& positions) {
  std::vector<Vector> units;
  for (Vector p : positions) {
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    for (double& c : p) c /= length;
    units.push_back(p);
  }
  return units;
}

/// The scene: a picture of kWide x kHigh pixels, 120 wide, whose texels obey polynomials.
struct Scene {
  std::vector<Vector> positions;
  std::vector<Polynomial> polynomials;
  std::vector<float> samples;  ///< [light][channel][texel]

  explicit Scene(double radius, double noise = 0) : positions(dome(radius)), polynomials(kTexels) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal(0, 1);
    for (Polynomial& a : polynomials) {
      a << 10 * normal(random), 10 * normal(random), 10 * normal(random), 25 * normal(random),
          25 * normal(random), 110;
    }
    samples.resize(positions.size() * 3 * kTexels);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      for (std::size_t t = 0; t < kTexels; ++t) {
        const double level = seen(i, t) + noise * normal(random);
        for (std::size_t c = 0; c < 3; ++c) {
          samples[(i * 3 + c) * kTexels + t] = static_cast<float>(level);
        }
      }
    }
  }

  /// What a photograph shows, from the geometry as it is drawn on paper.
  [[nodiscard]] double seen(std::size_t light, std::size_t texel) const {
    const double pixel = 120.0 / kWide;
    const double x = (static_cast<double>(texel % kWide) - 5.5) * pixel;
    const double y = (3.5 - static_cast<double>(texel / kWide)) * pixel;
    const Vector& p = positions[light];
    const double square = (p[0] - x) * (p[0] - x) + (p[1] - y) * (p[1] - y) + p[2] * p[2];
    const double u = (p[0] - x) / std::sqrt(square), v = (p[1] - y) / std::sqrt(square);
    const double strength = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / square;
    const Polynomial& a = polynomials[texel];
    return strength * (a[0] * u * u + a[1] * v * v + a[2] * u * v + a[3] * u + a[4] * v + a[5]);
  }

  [[nodiscard]] PhotoTile tile() const { return {kTexels, kTexels, samples.data()}; }
  [[nodiscard]] NearLights lights() const {
    return {positions, {kWide, kHigh, {0, 0, kWide, kHigh}, 120.0 / kWide}};
  }
};

struct Fit {
  std::vector<double> coef = std::vector<double>(kTexels * 18);
  std::vector<std::uint8_t> color;
};

Fit fit(const Scene& scene, bool near, int robust = 0) {
  const LightSolver solver = solve_lights(directions_of(scene.positions));
  const NearLights lights = scene.lights();
  FitOptions options;
  options.kind = MapKind::rgb;
  options.robust_passes = robust;
  Fit result;
  fit_tile(scene.tile(), solver, options, result.coef, result.color, {near ? &lights : nullptr, 0});
  return result;
}

/// The largest error of a coefficient.
double worst(const Scene& scene, const Fit& found) {
  double most = 0;
  for (std::size_t t = 0; t < kTexels; ++t) {
    for (std::size_t n = 0; n < 18; ++n) {
      const double wanted = scene.polynomials[t][static_cast<Eigen::Index>(n % 6)];
      most = std::max(most, std::abs(found.coef[t * 18 + n] - wanted));
    }
  }
  return most;
}

TEST(NearLights, AreSeenFromEachPixelAsGeometryHasIt) {
  const NearLights lights({{{30, -40, 0.5}, {0, 0, 100}}}, {4, 2, {1, 1, 2, 1}, 10});
  // The region's texel 1 is the whole picture's pixel (2, 1): its centre lies at (5, -5).
  const NearLights::Seen low = lights.at(0, 1);
  const double away = std::sqrt(25.0 * 25 + 35 * 35 + 0.25);
  EXPECT_NEAR(low.u, 25 / away, 1e-15);
  EXPECT_NEAR(low.v, -35 / away, 1e-15);
  EXPECT_NEAR(low.falloff, (900 + 1600 + 0.25) / (away * away), 1e-14);
  const NearLights::Seen high = lights.at(1, 0);  // pixel (1, 1): (-5, -5)
  EXPECT_NEAR(high.u, 5 / std::sqrt(10050.0), 1e-15);
  EXPECT_NEAR(high.falloff, 10000 / 10050.0, 1e-14);
}

TEST(NearLights, GiveBackThePolynomialsThatFarLightsMiss) {
  const Scene scene(150);
  const LightSolver solver = solve_lights(directions_of(scene.positions));
  // Samples are floats of about 500 levels at most: an error of 500 * 2^-24, through the inverse.
  double brightest = 0;
  for (const float sample : scene.samples) brightest = std::max(brightest, double{sample});
  const auto lights = static_cast<double>(scene.positions.size());
  const double rounding =
      brightest * 0x1p-24 * std::sqrt(lights) * (solver.condition / solver.singular_values[0]);
  EXPECT_LT(worst(scene, fit(scene, true)), 10 * rounding);  // the texels' own inverses differ
  EXPECT_LT(worst(scene, fit(scene, true, 3)), 10 * rounding);
  EXPECT_GT(worst(scene, fit(scene, false)), 20);
}

TEST(NearLights, AMillionAwayAreFarLights) {
  const Scene scene(1e6);
  const LightSolver solver = solve_lights(directions_of(scene.positions));
  const Fit near = fit(scene, true), far = fit(scene, false);
  // The corner lies d away from the centre. A direction turns by at most d / |P|, a basis function
  // by at most twice that and the strength by 2 d / |P|. With e the change of a row, the solution
  // changes by |P| (|dy| + |dA| |a|) to first order (no residual): the samples are exact.
  const double turn = std::hypot(60, 40) / 1e6, rows = std::sqrt(31.0);
  const double inverse = solver.condition / solver.singular_values[0];
  double most = 0;
  for (const Polynomial& a : scene.polynomials) most = std::max(most, a.norm());
  const double basis = 2 * turn * std::sqrt(5.0) * rows;  // five functions that change
  const double samples = 2 * turn * 1.01 * 300 * rows;    // of 300 levels at most
  const double rounding = 300 * 0x1p-23 * rows;
  const double bound = inverse * (samples + basis * most + rounding) * 1.01;
  for (std::size_t n = 0; n < near.coef.size(); ++n) {
    ASSERT_NEAR(near.coef[n], far.coef[n], bound) << n;
  }
  EXPECT_LT(bound, 1);
}

TEST(NearLights, LeaveOpenWhatTheyLeaveOpenAtTheCentre) {
  // One ring has rank 5 in the centre; elsewhere it is barely 6, by a hair that noise would follow.
  Scene scene(400, 0.5);
  std::vector<Vector> ring;
  std::vector<float> samples;
  for (std::size_t i = 1; i < scene.positions.size(); i += 3) {
    const Vector& p = directions_of(scene.positions)[i];
    ring.push_back({400 * p[0], 400 * p[1], 400 * p[2]});
    const auto from = scene.samples.begin() + static_cast<std::ptrdiff_t>(i * 3 * kTexels);
    samples.insert(samples.end(), from, from + 3 * kTexels);
  }
  scene.positions = ring;
  scene.samples = samples;
  ASSERT_EQ(solve_lights(directions_of(ring)).rank, 5);
  for (const double a : fit(scene, true).coef) ASSERT_LT(std::abs(a), 400);
}

TEST(NearLights, AreJudgedAsPhotographsShowThem) {
  const Scene scene(150);
  const NearLights lights = scene.lights();
  std::vector<double> exact(kTexels * 18);
  for (std::size_t n = 0; n < exact.size(); ++n) {
    exact[n] = scene.polynomials[n / 18][static_cast<Eigen::Index>(n % 6)];
  }
  const auto directions = directions_of(scene.positions);
  std::vector<Squares> as_near(directions.size()), as_far(directions.size());
  add_squares(scene.tile(), directions, MapKind::rgb, exact, {}, as_near, {}, {&lights, 0});
  add_squares(scene.tile(), directions, MapKind::rgb, exact, {}, as_far);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    double beyond = 0;  // what white cuts off, which is in no photograph of this scene's floats
    for (std::size_t t = 0; t < kTexels; ++t) {
      const double level = scene.seen(i, t), off = level - std::clamp(level, 0.0, 255.0);
      beyond += off * off;
    }
    EXPECT_NEAR(as_near[i][1], beyond, 1e-4 * (1 + beyond)) << i;
    EXPECT_GT(as_far[i][1], beyond + 100 * kTexels * (i == 0 ? 0.01 : 1));
  }
}

TEST(NearLights, LeaveOneOutIsWhatAFitWithoutTheLightMisses) {
  Scene scene(150, 3);
  const NearLights all = scene.lights();
  const LightSolver solver = solve_lights(directions_of(scene.positions));
  std::vector<double> squares(scene.positions.size());
  add_leave_one_out(scene.tile(), solver, MapKind::rgb, squares, {&all, 0});
  constexpr std::size_t kLeft = 7;
  Scene others = scene;
  others.positions.erase(others.positions.begin() + kLeft);
  const auto from = others.samples.begin() + kLeft * 3 * kTexels;
  others.samples.erase(from, from + 3 * kTexels);
  Scene predicted = scene;
  const Fit without = fit(others, true);
  double wanted = 0;
  for (std::size_t t = 0; t < kTexels; ++t) {
    for (std::size_t k = 0; k < 6; ++k) {
      predicted.polynomials[t][static_cast<Eigen::Index>(k)] = without.coef[t * 18 + k];
    }
    const double off = predicted.seen(kLeft, t) - double{scene.samples[kLeft * 3 * kTexels + t]};
    wanted += 3 * off * off;
  }
  EXPECT_NEAR(squares[kLeft], wanted, 1e-4 * wanted);
}

}  // namespace
}  // namespace ptm::golden
