#include "golden/fit/fit_lrgb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "golden/fit/fit_report.h"
#include "golden/scene/relief.h"

namespace ptm::golden {
namespace {

using Polynomial = Eigen::Matrix<double, 6, 1>;

/// A lit texel that never goes dark: L between about 60 and 255, its largest sample exactly 255.
Polynomial bright_polynomial(std::mt19937& random, const Capture& capture) {
  std::uniform_real_distribution<double> slope(-60, 60);
  Polynomial a;
  a << slope(random) / 2, slope(random) / 2, slope(random) / 2, slope(random), slope(random), 190;
  double most = 0;
  for (const auto& d : capture.directions) most = std::max(most, light_basis(d[0], d[1]).dot(a));
  return a * (255 / most);
}

/// Photographs that are exactly rgb * L / 255 up to the float they are kept in.
Capture exact_capture(int width, int height, int lights, std::vector<Polynomial>& truth,
                      const std::array<double, 3>& rgb) {
  Capture capture{.width = width,
                  .height = height,
                  .names = {},
                  .directions = {},
                  .photographs = {},
                  .notes = {}};
  capture.directions = spread_lights(lights);
  std::mt19937 random(4);
  for (int t = 0; t < width * height; ++t) truth.push_back(bright_polynomial(random, capture));
  for (const auto& d : capture.directions) {
    Image<float> photograph(width, height, 3);
    for (std::size_t t = 0; t < truth.size(); ++t) {
      const double luminance = light_basis(d[0], d[1]).dot(truth[t]);
      for (std::size_t c = 0; c < 3; ++c) {
        photograph.samples[t * 3 + c] = static_cast<float>(rgb[c] * luminance / 255);
      }
    }
    capture.photographs.push_back(std::move(photograph));
    capture.names.push_back("light " + std::to_string(capture.names.size()));
  }
  return capture;
}

TEST(FitLrgb, RecoversExactPolynomialsAndTheirColour) {
  std::vector<Polynomial> truth;
  const std::array<double, 3> rgb{200, 120, 40};
  const Capture capture = exact_capture(61, 37, 24, truth, rgb);
  const LrgbFit fit = fit_lrgb(capture, solve_lights(capture.directions));
  // Samples are floats: 2^-24 relative each, at most 255 * 2^-24 * (sum of |inverse| in a row).
  const double tolerance = 255 * 0x1p-23 * 24;
  for (std::size_t t = 0; t < truth.size(); ++t) {
    for (std::size_t i = 0; i < 6; ++i) {
      ASSERT_NEAR(fit.coef[t * 6 + i], truth[t][static_cast<Eigen::Index>(i)], tolerance);
    }
    for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(fit.color[t * 3 + c], rgb[c]);
  }
  EXPECT_LT(compare_lrgb(capture, fit.coef, fit.color).all.rmse, tolerance);
}

TEST(FitLrgb, GivesBlackAndZeroForATexelThatIsNeverLit) {
  std::vector<Polynomial> truth;
  Capture capture = exact_capture(5, 2, 12, truth, {10, 20, 30});
  for (Image<float>& photograph : capture.photographs) {
    for (int c = 0; c < 3; ++c) photograph.at(3, 1, c) = 0;
  }
  const LrgbFit fit = fit_lrgb(capture, solve_lights(capture.directions));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(fit.coef[8 * 6 + i], 0.0);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(fit.color[8 * 3 + c], 0);
  for (const double a : fit.coef) ASSERT_TRUE(std::isfinite(a));
}

TEST(FitLrgb, KeepsTheColourOfTexelsThatSaturate) {
  std::vector<Polynomial> truth;
  Capture capture = exact_capture(2, 1, 12, truth, {255, 255, 255});
  for (Image<float>& photograph : capture.photographs) {
    for (float& sample : photograph.samples) sample = 255;
  }
  const LrgbFit fit = fit_lrgb(capture, solve_lights(capture.directions));
  EXPECT_EQ(fit.color, std::vector<std::uint8_t>(6, 255));
  EXPECT_NEAR(fit.coef[5], 255, 1e-9);
  EXPECT_NEAR(fit.coef[0], 0, 1e-9);
}

TEST(FitLrgb, FitsTheSamplesItIsGivenWithTooFewLights) {
  std::vector<Polynomial> truth;
  const Capture capture = exact_capture(9, 9, 4, truth, {200, 200, 200});
  const LightSolver solver = solve_lights(capture.directions);
  EXPECT_EQ(solver.rank, 4);
  const LrgbFit fit = fit_lrgb(capture, solver);
  EXPECT_LT(compare_lrgb(capture, fit.coef, fit.color).all.rmse, 1e-4);
}

TEST(FitLrgb, IsTheSameWhateverTheTilesAre) {
  // 83 x 50 texels are two tiles and a rest; each texel fitted alone is one tile.
  std::vector<Polynomial> truth;
  const Capture capture = exact_capture(83, 50, 10, truth, {180, 90, 220});
  const LightSolver solver = solve_lights(capture.directions);
  const LrgbFit fit = fit_lrgb(capture, solver);
  for (const std::size_t t : {0U, 2047U, 2048U, 4095U, 4096U, 4149U}) {
    PhotoTile tile{.texels = 1, .samples = {}};
    for (const Image<float>& p : capture.photographs) {
      tile.samples.push_back(std::span(p.samples).subspan(t * 3, 3));
    }
    std::array<double, 6> coef{};
    std::array<std::uint8_t, 3> color{};
    fit_lrgb_tile(tile, solver, coef, color);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(coef[i], fit.coef[t * 6 + i], 1e-9);
    EXPECT_TRUE(std::equal(color.begin(), color.end(),
                           fit.color.begin() + static_cast<std::ptrdiff_t>(t * 3)));
  }
}

TEST(CompareLrgb, MeasuresAKnownDifference) {
  Capture capture{.width = 2,
                  .height = 1,
                  .names = {"one"},
                  .directions = {{0, 0, 1}},
                  .photographs = {Image<float>(2, 1, 3)},
                  .notes = {}};
  capture.photographs[0].samples = {10, 20, 30, 250, 250, 250};
  std::vector<double> coef(12, 0.0);
  coef[5] = 255;      // texel 0: its colour as it is
  coef[11] = 100000;  // texel 1: limited to 255
  const std::vector<std::uint8_t> color{13, 20, 26, 255, 255, 255};
  const FitReport report = compare_lrgb(capture, coef, color);
  EXPECT_NEAR(report.all.rmse, std::sqrt((9 + 0 + 16 + 3 * 25) / 6.0), 1e-9);
  EXPECT_NEAR(report.all.channel_rmse[2], std::sqrt((16 + 25) / 2.0), 1e-9);
  EXPECT_NEAR(report.all.psnr_db, 20 * std::log10(255 / report.all.rmse), 1e-12);
  EXPECT_NEAR(report.lights.at(0).rmse, report.all.rmse, 1e-12);
}

TEST(CompareLrgb, RefusesMapsOfAnotherSize) {
  std::vector<Polynomial> truth;
  const Capture capture = exact_capture(3, 3, 6, truth, {1, 2, 3});
  EXPECT_THROW((void)compare_lrgb(capture, std::vector<double>(6), std::vector<std::uint8_t>(3)),
               std::invalid_argument);
}

}  // namespace
}  // namespace ptm::golden
