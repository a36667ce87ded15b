#include "golden/fit/fit_tile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "golden/fit/fit_quality.h"
#include "tests/fit/made_photographs.h"

namespace ptm::golden {
namespace {

using tests::bright_polynomials;
using tests::MadePhotographs;

struct Fit {
  std::vector<double> coef;
  std::vector<std::uint8_t> color;
};

Fit fit(const MadePhotographs& lit, const FitOptions& options = {}) {
  PtmMap shape;
  shape.kind = options.kind;
  Fit made{std::vector<double>(lit.texels * shape.polynomials() * 6),
           std::vector<std::uint8_t>(lit.texels * shape.color_bytes())};
  fit_tile(lit.tile(), solve_lights(lit.directions), options, made.coef, made.color);
  return made;
}

double rmse(const MadePhotographs& lit, const Fit& made, MapKind kind) {
  std::vector<Squares> squares(lit.directions.size());
  add_squares(lit.tile(), lit.directions, kind, made.coef, made.color, squares);
  Squares sum{};
  for (const Squares& one : squares) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += one[c];
  }
  return to_residual(sum, static_cast<double>(lit.texels * squares.size())).rmse;
}

/// Samples are floats: 2^-24 relative each, summed over 24 lights by |inverse| <= 1 or so.
constexpr double kFloatError = 255 * 0x1p-23 * 24;

TEST(FitTile, RecoversExactPolynomialsAndTheirColour) {
  MadePhotographs lit(24, 2257);  // blocks of 256 and a rest, 24 lights: whole groups of four
  const auto truth = bright_polynomials(lit);
  const std::array<double, 3> rgb{200, 120, 40};
  lit.light(truth, rgb);
  for (const ColorRule rule : {ColorRule::least_squares, ColorRule::average}) {
    for (const FullRange full : {FullRange::luminance, FullRange::color}) {
      const Fit made = fit(lit, {.color = rule, .full_range = full});
      const double k = full == FullRange::color ? 255.0 / 200 : 1;
      for (std::size_t t = 0; t < truth.size(); ++t) {
        for (std::size_t i = 0; i < 6; ++i) {
          ASSERT_NEAR(made.coef[t * 6 + i], truth[t][static_cast<Eigen::Index>(i)] / k,
                      kFloatError);
        }
        for (std::size_t c = 0; c < 3; ++c)
          ASSERT_EQ(made.color[t * 3 + c], std::round(k * rgb[c]));
      }
      EXPECT_LT(rmse(lit, made, MapKind::lrgb), kFloatError);
    }
  }
}

TEST(FitTile, NeedNotClampAColourThatIsBrighterThanItsLuminance) {
  // A red thing with white highlights: where the brightest luminance is 255, the red of the
  // least-squares colour would have to be 338.
  MadePhotographs lit(12, 3);
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t t = 0; t < 3; ++t) {
      lit.at(i, 0, t) = i % 4 == 0 ? 200.0F : 250.0F;
      lit.at(i, 1, t) = lit.at(i, 2, t) = i % 4 == 0 ? 200.0F : 30.0F;
    }
  }
  const Fit clamped = fit(lit, {.full_range = FullRange::luminance});
  const Fit made = fit(lit);
  EXPECT_EQ(clamped.color[0], 255);
  EXPECT_EQ(clamped.color[1], 163);
  EXPECT_EQ(made.color[0], 255);
  EXPECT_EQ(made.color[1], 123);
  EXPECT_LT(rmse(lit, made, MapKind::lrgb), rmse(lit, clamped, MapKind::lrgb) - 1);
}

TEST(FitTile, KeepsTheLuminanceOfATexelFarAboveWhiteWithinTenBits) {
  MadePhotographs lit(24, 40);
  lit.light(bright_polynomials(lit), {200, 120, 40});
  for (std::size_t i = 0; i < lit.directions.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) lit.at(i, c, 7) *= 1e4F;
  }
  const Fit made = fit(lit);
  double most = 0;
  for (const auto& d : lit.directions) {
    double luminance = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      luminance += made.coef[7 * 6 + i] * light_basis(d[0], d[1])[static_cast<Eigen::Index>(i)];
    }
    most = std::max(most, luminance);
  }
  EXPECT_NEAR(most, 1020, 0.1);
  EXPECT_EQ(made.color[7 * 3], 255);
  EXPECT_EQ(made.color[8 * 3], 255);
  EXPECT_EQ(made.color[8 * 3 + 1], 153);
}

TEST(FitTile, RecoversEachChannelOfAnRgbMapWithAnyNumberOfLights) {
  for (const std::size_t lights : {9U, 10U, 11U, 12U}) {
    MadePhotographs lit(lights, 300);
    const auto truth = bright_polynomials(lit);
    const std::array<double, 3> rgb{200, 120, 40};
    lit.light(truth, rgb);
    const Fit made = fit(lit, {.kind = MapKind::rgb});
    for (std::size_t n = 0; n < made.coef.size(); ++n) {
      const double expected =
          truth[n / 18][static_cast<Eigen::Index>(n % 6)] * rgb[n / 6 % 3] / 255;
      ASSERT_NEAR(made.coef[n], expected, kFloatError) << lights << " lights";
    }
    EXPECT_TRUE(made.color.empty());
  }
}

TEST(FitTile, RecoversLumaAndChromaOfALumMap) {
  // Chroma (Cr, Cb) = (140, 110) and any Y: red - Y and blue - Y do not depend on the light.
  MadePhotographs lit(20, 300);
  const auto truth = bright_polynomials(lit);
  const double red = 1.402 * 12, blue = 1.772 * -18;
  const double green = (-0.299 * red - 0.114 * blue) / 0.587;
  for (std::size_t i = 0; i < lit.directions.size(); ++i) {
    for (std::size_t t = 0; t < lit.texels; ++t) {
      const double y =
          light_basis(lit.directions[i][0], lit.directions[i][1]).dot(truth[t]) * 0.7 + 40;
      lit.at(i, 0, t) = static_cast<float>(y + red);
      lit.at(i, 1, t) = static_cast<float>(y + green);
      lit.at(i, 2, t) = static_cast<float>(y + blue);
    }
  }
  const Fit made = fit(lit, {.kind = MapKind::lum});
  for (std::size_t t = 0; t < truth.size(); ++t) {
    ASSERT_EQ(made.color[t * 2], 140);
    ASSERT_EQ(made.color[t * 2 + 1], 110);
    ASSERT_NEAR(made.coef[t * 6 + 5], truth[t][5] * 0.7 + 40, kFloatError);
    ASSERT_NEAR(made.coef[t * 6], truth[t][0] * 0.7, kFloatError);
  }
  EXPECT_LT(rmse(lit, made, MapKind::lum), 1e-3);  // JFIF's matrix has six digits
}

TEST(FitTile, GivesTheAverageColourTheWholeRangeOfAByte) {
  MadePhotographs lit(24, 40);
  const auto truth = bright_polynomials(lit);
  lit.light(truth, {80, 40, 20});
  const Fit made = fit(lit, {.color = ColorRule::average});
  const Fit bright = fit(lit, {.color = ColorRule::average, .full_range = FullRange::luminance});
  for (std::size_t t = 0; t < lit.texels; ++t) {
    EXPECT_EQ(made.color[t * 3], 255);
    EXPECT_NEAR(made.color[t * 3 + 1], 127.5, 0.6);
    EXPECT_NEAR(bright.color[t * 3], 80, 1);  // brightest photograph over the average one
    EXPECT_NEAR(bright.color[t * 3 + 1], 40, 1);
  }
  // A colour rounded to a byte: half a level at luminance 80, or at 255.
  EXPECT_LT(rmse(lit, made, MapKind::lrgb), 0.5 * 80 / 255);
  EXPECT_LT(rmse(lit, bright, MapKind::lrgb), 0.5);
}

TEST(FitTile, GivesBlackAndZeroForATexelThatIsNeverLit) {
  for (const MapKind kind : {MapKind::lrgb, MapKind::rgb, MapKind::lum}) {
    for (const ColorRule rule : {ColorRule::least_squares, ColorRule::average}) {
      for (const int passes : {0, 2}) {
        MadePhotographs lit(12, 10);
        lit.light(bright_polynomials(lit), {10, 20, 30});
        for (std::size_t i = 0; i < 12; ++i) {
          for (std::size_t c = 0; c < 3; ++c) lit.at(i, c, 8) = 0;
        }
        const Fit made = fit(lit, {.kind = kind, .color = rule, .robust_passes = passes});
        const std::size_t size = made.coef.size() / 10, bytes = made.color.size() / 10;
        for (std::size_t k = 0; k < size; ++k) EXPECT_EQ(made.coef[8 * size + k], 0.0);
        for (std::size_t k = 0; k < bytes; ++k) {
          EXPECT_EQ(made.color[8 * bytes + k], kind == MapKind::lum ? 128 : 0);
        }
        for (const double a : made.coef) ASSERT_TRUE(std::isfinite(a));
      }
    }
  }
}

TEST(FitTile, KeepsTheColourOfTexelsThatSaturate) {
  MadePhotographs lit(12, 2);
  for (float& sample : lit.samples) sample = 255;
  const Fit made = fit(lit);
  EXPECT_EQ(made.color, std::vector<std::uint8_t>(6, 255));
  EXPECT_NEAR(made.coef[5], 255, 1e-9);
  EXPECT_NEAR(made.coef[0], 0, 1e-9);
}

TEST(FitTile, FitsTheSamplesItIsGivenWithTooFewLights) {
  MadePhotographs lit(4, 81);
  lit.light(bright_polynomials(lit), {200, 200, 200});
  EXPECT_EQ(solve_lights(lit.directions).rank, 4);
  for (const int passes : {0, 2}) {
    EXPECT_LT(rmse(lit, fit(lit, {.robust_passes = passes}), MapKind::lrgb), 1e-3) << passes;
  }
}

TEST(FitTile, FitsAUnivariateMapWithoutTheOtherParameter) {
  MadePhotographs lit(6, 50);
  for (std::size_t i = 0; i < 6; ++i) {
    lit.directions[i] = {-1 + 0.4 * static_cast<double>(i), 0, 0};
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t t = 0; t < 50; ++t) {
        const double u = lit.directions[i][0];
        lit.at(i, c, t) = static_cast<float>(100 + 30 * u + 20 * u * u + double(t));
      }
    }
  }
  EXPECT_EQ(solve_lights(lit.directions).rank, 3);
  const Fit made = fit(lit, {.kind = MapKind::rgb});
  for (std::size_t p = 0; p < 150; ++p) {
    const double* a = made.coef.data() + p * 6;
    EXPECT_NEAR(a[0], 20, kFloatError);
    EXPECT_NEAR(a[3], 30, kFloatError);
    EXPECT_NEAR(a[5], 100 + double(p / 3), kFloatError);
    for (const std::size_t k : {1U, 2U, 4U}) EXPECT_NEAR(a[k], 0, 1e-12);
  }
}

TEST(FitTile, RobustPassesTakeHighlightsAndShadowsForWhatTheyAre) {
  MadePhotographs clean(40, 60);
  const auto truth = bright_polynomials(clean);
  clean.light(truth, {180, 180, 180});
  MadePhotographs spoilt = clean;
  for (std::size_t t = 0; t < 60; ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      spoilt.at(t % 40, c, t) = 255;
      for (const std::size_t shadow : {t + 7, t + 13, t + 22}) spoilt.at(shadow % 40, c, t) = 0;
    }
  }
  for (const MapKind kind : {MapKind::lrgb, MapKind::rgb, MapKind::lum}) {
    const double plain = rmse(clean, fit(spoilt, {.kind = kind}), kind);
    const double robust = rmse(clean, fit(spoilt, {.kind = kind, .robust_passes = 8}), kind);
    EXPECT_GT(plain, 5);
    EXPECT_LT(robust, plain / 10);
  }
}

TEST(FitTile, RobustPassesLeaveAnExactFitAsItIs) {
  MadePhotographs lit(24, 30);
  const auto truth = bright_polynomials(lit);
  lit.light(truth, {200, 120, 40});
  const Fit plain = fit(lit), robust = fit(lit, {.robust_passes = 3});
  for (std::size_t n = 0; n < plain.coef.size(); ++n) {
    EXPECT_NEAR(plain.coef[n], robust.coef[n], kFloatError);
  }
  EXPECT_EQ(plain.color, robust.color);
}

TEST(FitTile, IsTheSameWhateverTheTilesAre) {
  MadePhotographs lit(10, 700);
  lit.light(bright_polynomials(lit), {180, 90, 220});
  const Fit whole = fit(lit);
  const LightSolver solver = solve_lights(lit.directions);
  for (const std::size_t t : {0U, 255U, 256U, 511U, 699U}) {
    std::array<double, 6> coef{};
    std::array<std::uint8_t, 3> color{};
    fit_tile({1, lit.texels, lit.samples.data() + t}, solver, {}, coef, color);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(coef[i], whole.coef[t * 6 + i]) << t;
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(color[c], whole.color[t * 3 + c]) << t;
  }
}

TEST(FitTile, RefusesSizesThatDoNotAgree) {
  const MadePhotographs lit(6, 3);
  std::vector<double> coef(12);
  std::vector<std::uint8_t> color(9);
  EXPECT_THROW(fit_tile(lit.tile(), solve_lights(lit.directions), {}, coef, color),
               std::invalid_argument);
}

}  // namespace
}  // namespace ptm::golden
