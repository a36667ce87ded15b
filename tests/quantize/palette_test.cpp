#include "model/quantize/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>

#include "model/quantize/clusters.h"
#include "model/quantize/gain.h"
#include "model/quantize/quantize.h"
#include "tests/quantize/synthetic_map.h"

namespace ptm::quantize {
namespace {

using tests::synthetic_coefficients;
using tests::view;

/// Mean squared difference of luminance that a palette makes.
double distortion(const std::vector<double>& real, const Palette& palette) {
  const Gram g = hemisphere_gram();
  const std::size_t stride = static_cast<std::size_t>(palette.polynomials) * kSix;
  double sum = 0;
  for (std::size_t k = 0; k < real.size(); k += kSix) {
    const std::size_t entry = palette.index[k / stride] * stride + k % stride;
    Eigen::Matrix<double, 6, 1> e;
    for (std::size_t i = 0; i < kSix; ++i) {
      e[static_cast<Eigen::Index>(i)] = palette.coef[entry + i] - real[k + i];
    }
    sum += e.dot(g * e);
  }
  return sum / static_cast<double>(palette.index.size());
}

TEST(MakePalette, FindsClustersThatStandApart) {
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0, 0.1);
  std::vector<double> real;
  for (int t = 0; t < 600; ++t) {
    for (int i = 0; i < 6; ++i) real.push_back(40.0 * ((t % 5) * (i + 1) % 7) + noise(random));
  }
  const Palette palette = make_palette(view(real, 60, 10), {}, {.entries = 5}, hemisphere_gram());
  EXPECT_EQ(palette.entries(), 5);
  for (std::size_t t = 5; t < 600; ++t) ASSERT_EQ(palette.index[t], palette.index[t - 5]);
  EXPECT_LT(std::sqrt(distortion(real, palette)), 0.2);
}

TEST(MakePalette, IsTheSameForASeedAndAnotherForAnother) {
  const std::vector<double> real = synthetic_coefficients(40, 40, 9, 3);
  const RealMap map = view(real, 40, 40, 3);
  const Gram g = hemisphere_gram();
  const Palette a = make_palette(map, {}, {.entries = 30, .seed = 7}, g);
  const Palette b = make_palette(map, {}, {.entries = 30, .seed = 7}, g);
  const Palette c = make_palette(map, {}, {.entries = 30, .seed = 8}, g);
  EXPECT_EQ(a.coef, b.coef);
  EXPECT_EQ(a.index, b.index);
  EXPECT_NE(a.coef, c.coef);
  EXPECT_NEAR(distortion(real, a) / distortion(real, c), 1, 0.2);
}

TEST(MakePalette, GetsBetterWithRoundsAndWithEntries) {
  const std::vector<double> real = synthetic_coefficients(48, 48, 1);
  const RealMap map = view(real, 48, 48);
  const Gram g = hemisphere_gram();
  const double once = distortion(real, make_palette(map, {}, {.entries = 32, .rounds = 1}, g));
  double before = distortion(real, make_palette(map, {}, {.entries = 32, .rounds = 30}, g));
  EXPECT_LT(before, 0.95 * once);
  for (const int entries : {64, 128, 256}) {
    const double now = distortion(real, make_palette(map, {}, {.entries = entries}, g));
    EXPECT_LT(now, 0.9 * before) << entries;
    before = now;
  }
}

TEST(MakePalette, HoldsAMapOfFewPolynomialsExactlyAndUsesNoMoreEntriesThanItHas) {
  std::vector<double> real;
  for (int t = 0; t < 90; ++t) {
    for (int i = 0; i < 6; ++i) real.push_back(8.0 * (t % 3) + i);
  }
  const Palette palette = make_palette(view(real, 90, 1), {}, {.entries = 64}, hemisphere_gram());
  EXPECT_EQ(palette.entries(), 3);
  EXPECT_LT(distortion(real, palette), 1e-8);
  const Palette one = make_palette(view(std::vector<double>(60, 5.0), 10, 1), {}, {.entries = 2},
                                   hemisphere_gram());
  EXPECT_EQ(one.entries(), 1);
}

TEST(MakePalette, HeedsWeights) {
  // Two kinds of texel; the palette has room for the weighty one's two variants only.
  std::vector<double> real, weights;
  for (int t = 0; t < 400; ++t) {
    const bool heavy = t % 4 == 0;
    const double base = heavy ? (t % 8 == 0 ? 100 : 104) : (t % 3 == 0 ? -50.0 : 20.0);
    for (int i = 0; i < 6; ++i) real.push_back(base);
    weights.push_back(heavy ? 1.0 : 1e-9);
  }
  const Palette palette =
      make_palette(view(real, 20, 20), weights, {.entries = 2, .rounds = 50}, hemisphere_gram());
  EXPECT_NEAR(std::max(palette.coef[5], palette.coef[11]), 104, 1e-3);
  EXPECT_NEAR(std::min(palette.coef[5], palette.coef[11]), 100, 1e-3);
}

TEST(MakePalette, OfASampleServesAllTexels) {
  const std::vector<double> real = synthetic_coefficients(64, 64, 3);
  const RealMap map = view(real, 64, 64);
  const Gram g = hemisphere_gram();
  const Palette all = make_palette(map, {}, {.entries = 32, .sample = 0}, g);
  const Palette some = make_palette(map, {}, {.entries = 32, .sample = 1024}, g);
  EXPECT_EQ(some.index.size(), 4096U);
  EXPECT_LT(distortion(real, some), 1.25 * distortion(real, all));
}

TEST(MakePalette, ReportsProgressNoMoreOftenThanItSays) {
  const std::vector<double> real = synthetic_coefficients(32, 32, 3);
  int steps = 0;
  const PaletteOptions options{.entries = 40, .rounds = 3, .step = [&steps] { ++steps; }};
  (void)make_palette(view(real, 32, 32), {}, options, hemisphere_gram());
  EXPECT_EQ(steps, palette_steps(options));
}

TEST(MakePalette, RefusesBadInput) {
  const std::vector<double> real = synthetic_coefficients(4, 4, 1);
  const Gram g = hemisphere_gram();
  const RealMap map = view(real, 4, 4);
  EXPECT_THROW((void)make_palette(map, {}, {.entries = 1}, g), std::invalid_argument);
  EXPECT_THROW((void)make_palette(map, {}, {.entries = 65537}, g), std::invalid_argument);
  EXPECT_THROW((void)make_palette(view(real, 5, 4), {}, {}, g), std::invalid_argument);
  for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW((void)make_palette(map, std::vector<double>(16, bad), {}, g),
                 std::invalid_argument);
  }
  EXPECT_THROW((void)make_palette(map, std::vector<double>(16, 0.0), {}, g), std::invalid_argument);
}

TEST(Refine, MovesCentersThatNoPointIsNearestToToThePointsThatAreWorstOff) {
  const Points points{.dimensions = 1, .values = {0, 1, 8, 20, 21}};
  const std::vector<double> weights{1, 1, 1, 1, 1};
  // Three equal centers: the first takes all points, the other two go to 21 and to 20 at first.
  const Clusters clusters = refine(points, weights, {.dimensions = 1, .values = {5, 5, 5}}, 20);
  EXPECT_EQ(clusters.refilled, 2);
  const auto index = nearest(points, clusters.centers);
  EXPECT_EQ(std::set<std::uint16_t>(index.begin(), index.end()).size(), 3U);
  // As many points as centers need: the rest stay where they are.
  const Points one{.dimensions = 1, .values = {4}};
  const Clusters single =
      refine(one, std::vector<double>{1}, {.dimensions = 1, .values = {4, 4}}, 5);
  EXPECT_EQ(single.refilled, 0);
  EXPECT_EQ(single.means, (std::vector<double>{4, 4}));
}

TEST(StorePalette, PutsEachTexelsEntryInItsPlaceOnOneGrid) {
  const std::vector<double> real = synthetic_coefficients(20, 10, 6, 3);
  const RealMap map = view(real, 20, 10, 3);
  const Gram g = hemisphere_gram();
  const StoredMap held = quantize(map, reference::EvalConfig{}, Method::nearest_plane, g);
  const Palette palette = make_palette(map, {}, {.entries = 12}, g);
  const StoredMap stored =
      store_palette(map, palette, {held.bias, held.shift}, reference::EvalConfig{}, g);
  ASSERT_EQ(stored.coef.size(), real.size());
  EXPECT_EQ(stored.width, 20);
  EXPECT_EQ(stored.bias, held.bias);
  std::set<std::vector<std::uint16_t>> different;
  for (std::size_t t = 0; t < 200; ++t) {
    const auto at = stored.coef.begin() + static_cast<std::ptrdiff_t>(t * 18);
    different.insert(std::vector<std::uint16_t>(at, at + 18));
  }
  EXPECT_EQ(different.size(), 12U);
  EXPECT_NEAR(stored.rms_error, std::sqrt(distortion(real, palette) / 3), held.rms_error);
}

TEST(EqualizeStrength, MovesStrengthIntoColorWithoutChangingTheirProduct) {
  const std::vector<double> real = synthetic_coefficients(10, 10, 8);
  std::vector<std::uint8_t> color(300);
  std::mt19937 random(2);
  for (auto& c : color) c = static_cast<std::uint8_t>(random() % 200);
  std::vector<double> coef = real;
  const Gram g = hemisphere_gram();
  const std::vector<double> factors = equalize_strength(coef, color, g);
  double most = 0;
  for (std::size_t t = 0; t < 100; ++t) {
    const Eigen::Map<Eigen::Matrix<double, 6, 1>> a(&coef[t * 6]), first(&coef[0]);
    EXPECT_NEAR(a.dot(g * a), first.dot(g * first), 1e-6);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(coef[t * 6 + i] * factors[t], real[t * 6 + i], 1e-9);
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, factors[t] * color[t * 3 + c]);
  }
  EXPECT_NEAR(most, 255, 1e-9);
}

TEST(RefitColors, MakesUpForAPolynomialOfAnotherStrength) {
  const std::vector<double> real{-20, -30, 5, 40, 10, 120}, half{-10, -15, 2.5, 20, 5, 60};
  const std::vector<std::uint8_t> color{100, 50, 200};
  EXPECT_EQ(refit_colors(real, half, color, hemisphere_gram()),
            (std::vector<std::uint8_t>{200, 100, 255}));
  EXPECT_EQ(refit_colors(real, std::vector<double>(6), color, hemisphere_gram()), color);
}

}  // namespace
}  // namespace ptm::quantize
