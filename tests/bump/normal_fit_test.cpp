#include "golden/bump/normal_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "golden/bump/normal_table.h"

namespace ptm::golden {
namespace {

using std::numbers::pi;

TEST(NormalFit, IsTheClosedFormOnEveryDomain) {
  struct Row {
    BumpDomain domain;
    double constant, square;
  };
  for (const Row& row :
       {Row{BumpDomain::hemisphere, 9.0 / 8, -15.0 / 16},
        Row{BumpDomain::disc, 16.0 / 15, -4.0 / 5}, Row{BumpDomain::square, pi / 3, -pi / 4}}) {
    Eigen::Matrix<double, 6, 3> expected = Eigen::Matrix<double, 6, 3>::Zero();
    expected(3, 0) = expected(4, 1) = 1;
    expected(0, 2) = expected(1, 2) = row.square;
    expected(5, 2) = row.constant;
    EXPECT_LT((normal_fit(row.domain) - expected).cwiseAbs().maxCoeff(), 1e-12)
        << normal_fit(row.domain);
  }
}

TEST(NormalFit, LeavesNoPolynomialThatComesNearerOnASquareSummedByHand) {
  // Eq. 10 by a plain sum over the square, the root 0 in the corners: no coefficient moved either
  // way makes it smaller.
  const Eigen::Matrix<double, 6, 1> a =
      normal_fit(BumpDomain::square) * Eigen::Vector3d(0.2, -0.3, 0.9327);
  const auto sum = [](const Eigen::Matrix<double, 6, 1>& c) {
    double squares = 0;
    for (int i = 0; i < 200; ++i) {
      for (int j = 0; j < 200; ++j) {
        const double u = (i + 0.5) / 100 - 1, v = (j + 0.5) / 100 - 1;
        const double root = std::sqrt(std::max(0.0, 1 - u * u - v * v));
        const double f = 0.2 * u - 0.3 * v + 0.9327 * root;
        const double l = c[0] * u * u + c[1] * v * v + c[2] * u * v + c[3] * u + c[4] * v + c[5];
        squares += (l - f) * (l - f);
      }
    }
    return squares;
  };
  for (int k = 0; k < 6; ++k) {
    for (const double step : {-0.002, 0.002}) {
      Eigen::Matrix<double, 6, 1> moved = a;
      moved[k] += step;
      EXPECT_GT(sum(moved), sum(a)) << k;
    }
  }
}

TEST(NormalTable, GivesItsEntriesExactlyAndInterpolatesWithinItsBound) {
  const NormalTable table(BumpDomain::disc);
  const Eigen::Matrix<double, 6, 3> fit = normal_fit(BumpDomain::disc);
  double worst = 0;
  for (int i = 0; i <= 256; ++i) {
    for (int j = 0; j < 512; ++j) {
      const double latitude = pi / 2 * i / 256, longitude = 2 * pi * j / 512;
      const Eigen::Vector3d n(std::sin(latitude) * std::cos(longitude),
                              std::sin(latitude) * std::sin(longitude), std::cos(latitude));
      const auto a = table.find({n[0], n[1], n[2]});
      const Eigen::Matrix<double, 6, 1> exact = fit * n;
      double off = 0;
      for (std::size_t k = 0; k < 6; ++k) {
        off = std::max(off, std::abs(a[k] - exact[static_cast<Eigen::Index>(k)]));
      }
      if (i % 4 == 0 && j % 4 == 0) {
        ASSERT_LT(off, 1e-12) << i << ' ' << j;
      }
      worst = std::max(worst, off);
    }
  }
  const double bound = std::pow(pi / 2 / 64, 2) / 8 + std::pow(2 * pi / 128, 2) / 8;
  EXPECT_LT(worst, 16.0 / 15 * bound);
  EXPECT_GT(worst, bound / 4);  // it does interpolate
}

TEST(NormalTable, ClosesRoundInLongitudeAndTakesNormalsBelowTheHorizonAtTheHorizon) {
  const NormalTable table(BumpDomain::square, 9, 12);
  const auto before = table.find({std::cos(-1e-9), std::sin(-1e-9), 0});
  const auto after = table.find({std::cos(1e-9), std::sin(1e-9), 0});
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(before[k], after[k], 1e-8);
  EXPECT_EQ(table.find({0.6, 0, -0.8}), table.find({1, 0, 0}));
  EXPECT_THROW(NormalTable(BumpDomain::disc, 1, 12), std::invalid_argument);
}

}  // namespace
}  // namespace ptm::golden
