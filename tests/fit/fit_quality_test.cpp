#include "golden/fit/fit_quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/fit/made_photographs.h"

namespace ptm::golden {
namespace {

using tests::MadePhotographs;

TEST(FitQuality, MeasuresAKnownDifference) {
  MadePhotographs lit(1, 2);
  lit.directions = {{0, 0, 1}};
  lit.samples = {10, 250, 20, 250, 30, 250};
  std::vector<double> coef(12, 0.0), texels(2);
  coef[5] = 255;      // texel 0: its colour as it is
  coef[11] = 100000;  // texel 1: limited to 255
  const std::vector<std::uint8_t> color{13, 20, 26, 255, 255, 255};
  std::vector<Squares> squares(1);
  add_squares(lit.tile(), lit.directions, MapKind::lrgb, coef, color, squares, texels);
  EXPECT_NEAR(squares[0][0], 9 + 25, 1e-9);
  EXPECT_NEAR(squares[0][1], 0 + 25, 1e-9);
  EXPECT_NEAR(texels[0], 9 + 16, 1e-9);
  EXPECT_NEAR(texels[1], 75, 1e-9);
  const Residual r = to_residual(squares[0], 2);
  EXPECT_NEAR(r.rmse, std::sqrt((9 + 0 + 16 + 3 * 25) / 6.0), 1e-9);
  EXPECT_NEAR(r.channel_rmse[2], std::sqrt((16 + 25) / 2.0), 1e-9);
  EXPECT_NEAR(r.psnr_db, 20 * std::log10(255 / r.rmse), 1e-12);
  EXPECT_NEAR(r.channel_psnr_db[2], 20 * std::log10(255 / r.channel_rmse[2]), 1e-12);
}

TEST(FitQuality, RendersLumByJfifAndRgbByChannel) {
  MadePhotographs lit(1, 1);
  lit.directions = {{0, 0, 1}};
  lit.samples = {100 + 1.402F * 10, 100 - 0.714136F * 10 + 0.344136F * 20, 100 - 1.772F * 20};
  std::vector<Squares> squares(1);
  add_squares(lit.tile(), lit.directions, MapKind::lum, std::vector<double>{0, 0, 0, 0, 0, 100},
              std::vector<std::uint8_t>{138, 108}, squares);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(squares[0][c], 0, 1e-8);
  std::vector<double> three(18);
  three[5] = double{lit.samples[0]} + 1;
  three[11] = double{lit.samples[1]} + 2;
  three[17] = 300;
  add_squares(lit.tile(), lit.directions, MapKind::rgb, three, {}, squares);
  EXPECT_NEAR(squares[0][0], 1, 1e-4);
  EXPECT_NEAR(squares[0][1], 4, 1e-4);
  EXPECT_NEAR(squares[0][2], std::pow(255 - double{lit.samples[2]}, 2), 1e-4);
}

TEST(FitQuality, RefusesMapsOfAnotherSize) {
  const MadePhotographs lit(6, 3);
  std::vector<Squares> squares(6);
  EXPECT_THROW(add_squares(lit.tile(), lit.directions, MapKind::lrgb, std::vector<double>(6),
                           std::vector<std::uint8_t>(3), squares),
               std::invalid_argument);
}

/// What a fit without light i misses it by, found by making that fit.
double refitted(const MadePhotographs& lit, std::size_t i, MapKind kind) {
  const MadePhotographs others = lit.without(i);
  const LightSolver solver = solve_lights(others.directions);
  const auto basis = light_basis(lit.directions[i][0], lit.directions[i][1]);
  double squares = 0;
  for (const auto& weights : fitted_signals(kind)) {
    for (std::size_t t = 0; t < lit.texels; ++t) {
      const auto signal = [&](const MadePhotographs& of, std::size_t light) {
        double y = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          y += weights[c] * double{of.samples[(light * 3 + c) * of.texels + t]};
        }
        return y;
      };
      Eigen::VectorXd y(static_cast<Eigen::Index>(others.directions.size()));
      for (std::size_t k = 0; k < others.directions.size(); ++k) {
        y[static_cast<Eigen::Index>(k)] = signal(others, k);
      }
      const double miss = signal(lit, i) - basis.dot(solver.inverse * y);
      squares += miss * miss;
    }
  }
  return squares;
}

TEST(LeaveOneOut, IsWhatFitsWithoutEachLightMissItBy) {
  MadePhotographs lit(11, 5);
  lit.noise();
  const LightSolver solver = solve_lights(lit.directions);
  for (const MapKind kind : {MapKind::lrgb, MapKind::rgb, MapKind::lum}) {
    std::vector<double> squares(11);
    add_leave_one_out(lit.tile(), solver, kind, squares);
    for (std::size_t i = 0; i < 11; ++i) {
      ASSERT_TRUE(has_leave_one_out(solver, i));
      const double expected = refitted(lit, i, kind);
      EXPECT_NEAR(squares[i], expected, 1e-9 * expected) << "light " << i;
    }
  }
}

TEST(LeaveOneOut, HoldsForLightsOnARingWhereTheFitIsOfMinimumNorm) {
  MadePhotographs lit(9, 4);
  lit.noise();
  for (std::size_t i = 0; i < 9; ++i) {
    const double angle = 0.7 * static_cast<double>(i);
    lit.directions[i] = {0.6 * std::cos(angle), 0.6 * std::sin(angle), 0.8};
  }
  const LightSolver solver = solve_lights(lit.directions);
  EXPECT_EQ(solver.rank, 5);
  std::vector<double> squares(9);
  add_leave_one_out(lit.tile(), solver, MapKind::rgb, squares);
  for (std::size_t i = 0; i < 9; ++i) {
    const double expected = refitted(lit, i, MapKind::rgb);
    EXPECT_NEAR(squares[i], expected, 1e-8 * expected) << "light " << i;
  }
}

TEST(LeaveOneOut, HasNoAnswerWhereNoOtherLightSpeaks) {
  MadePhotographs lit(6, 2);  // six lights, six coefficients: each is needed
  lit.noise();
  const LightSolver solver = solve_lights(lit.directions);
  std::vector<double> squares(6);
  add_leave_one_out(lit.tile(), solver, MapKind::rgb, squares);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_FALSE(has_leave_one_out(solver, i));
    EXPECT_EQ(squares[i], 0);
  }
}

}  // namespace
}  // namespace ptm::golden
