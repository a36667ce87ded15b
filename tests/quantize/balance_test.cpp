#include "model/quantize/balance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "model/quantize/gram.h"
#include "model/quantize/quantize.h"
#include "model/reference/evaluate.h"
#include "model/reference/light_code.h"

namespace ptm::quantize {
namespace {

using Lights = std::vector<std::array<double, 2>>;

Lights grid_of_lights() {
  Lights lights;
  for (int y = -6; y <= 6; ++y) {
    for (int x = -6; x <= 6; ++x) {
      if (x * x + y * y <= 36) lights.push_back({x / 6.0, y / 6.0});
    }
  }
  return lights;
}

double luminance(const double* a, const std::array<double, 2>& light) {
  const auto b = basis(light[0], light[1]);
  double l = 0;
  for (std::size_t i = 0; i < kSix; ++i) l += a[i] * b[static_cast<Eigen::Index>(i)];
  return l;
}

struct BrightMap {
  std::vector<double> coef;
  std::vector<std::uint8_t> color;
};

/// Texels whose luminance reaches 420 while no channel is above 150.
BrightMap bright_map(std::size_t texels) {
  BrightMap map;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> slope(-90, 90), top(150, 330);
  for (std::size_t t = 0; t < texels; ++t) {
    for (const double a : {-60.0, -60.0, 5.0, slope(random), slope(random), top(random)}) {
      map.coef.push_back(a);
    }
    for (int c = 0; c < 3; ++c) map.color.push_back(static_cast<std::uint8_t>(random() % 151));
  }
  return map;
}

TEST(BalanceLuminance, BringsLuminanceIntoRangeAndLeavesTheBrightestChannelsPictureAsItWas) {
  BrightMap map = bright_map(300);
  const BrightMap before = map;
  const Lights lights = grid_of_lights();
  const Balance balance = balance_luminance(map.coef, map.color, lights, reference::kPaper8);
  EXPECT_GT(balance.exceeding, 100U);
  EXPECT_EQ(balance.scaled, balance.exceeding);
  EXPECT_EQ(balance.remaining, 0U);
  for (std::size_t t = 0; t < 300; ++t) {
    const auto brightest = static_cast<std::size_t>(
        std::max_element(&before.color[t * 3], &before.color[t * 3] + 3) - &before.color[0]);
    for (const auto& light : lights) {
      const double was = luminance(&before.coef[t * kSix], light);
      const double is = luminance(&map.coef[t * kSix], light);
      ASSERT_LE(is, 255 + 1e-9);
      ASSERT_NEAR(map.color[brightest] * is, before.color[brightest] * was, 1e-6);
      for (std::size_t c = t * 3; c < t * 3 + 3; ++c) {
        ASSERT_LE(std::abs(map.color[c] * is - before.color[c] * was), 0.5 * std::abs(is) + 1e-6);
      }
    }
  }
}

TEST(BalanceLuminance, GoesOnlyAsFarAsTheBrightestChannelAllows) {
  std::vector<double> coef{0, 0, 0, 0, 0, 510, 0, 0, 0, 0, 0, 510,
                           0, 0, 0, 0, 0, 510, 0, 0, 0, 0, 0, 200};
  std::vector<std::uint8_t> color{200, 80, 0, 255, 10, 10, 0, 0, 0, 9, 9, 9};
  const Balance balance = balance_luminance(coef, color, Lights{{0, 0}}, reference::kPaper8);
  EXPECT_EQ(balance.exceeding, 3U);
  EXPECT_EQ(balance.scaled, 1U);
  EXPECT_EQ(balance.remaining, 3U);
  EXPECT_NEAR(coef[5], 510 * 200.0 / 255, 1e-9);
  EXPECT_EQ(color, (std::vector<std::uint8_t>{255, 102, 0, 255, 10, 10, 0, 0, 0, 9, 9, 9}));
  EXPECT_EQ(coef[11], 510);
  EXPECT_EQ(coef[17], 510);
  EXPECT_EQ(coef[23], 200);
}

TEST(BalanceLuminance, KnowsTheFractionBitsOfTheLargestLuminance) {
  reference::EvalConfig config = reference::kPaper8;
  std::vector<double> coef{0, 0, 0, 0, 0, 255.9};
  std::vector<std::uint8_t> color{100, 100, 100};
  EXPECT_EQ(balance_luminance(coef, color, Lights{{0, 0}}, config).exceeding, 1U);
  coef = {0, 0, 0, 0, 0, 255.9};
  config.lum_frac = 4;
  config.guard = 4;
  EXPECT_EQ(balance_luminance(coef, color, Lights{{0, 0}}, config).exceeding, 0U);
}

struct Picture {
  std::size_t saturated = 0;
  double rmse = 0;
};

/// Renders with paper8's arithmetic and compares with colour * L / 255 of `truth`.
Picture render(const BrightMap& map, const BrightMap& truth, const Lights& lights) {
  const auto& config = reference::kPaper8;
  const auto texels = static_cast<int>(map.color.size() / 3);
  const StoredMap stored =
      quantize({.width = texels, .height = 1, .polynomials = 1, .coef = map.coef}, config,
               Method::nearest_plane, hemisphere_gram());
  Picture picture;
  double squares = 0;
  for (const auto& light : lights) {
    for (std::size_t t = 0; t * 3 < map.color.size(); ++t) {
      reference::LrgbOperands<> in;
      for (std::size_t i = 0; i < kSix; ++i) {
        in.coef[i] = stored.coef[t * kSix + i];
        in.bias[i] = stored.bias[i];
        in.shift[i] = stored.shift[i];
      }
      for (std::size_t c = 0; c < 3; ++c) in.rgb[c] = map.color[t * 3 + c];
      in.lu = *reference::light_code(config, light[0]);
      in.lv = *reference::light_code(config, light[1]);
      const auto pixel = reference::evaluate_lrgb(config, in);
      picture.saturated += pixel.luminance.acc > 255 ? 1U : 0U;
      const double l = luminance(&truth.coef[t * kSix], light);
      for (std::size_t c = 0; c < 3; ++c) {
        const double right = std::clamp(truth.color[t * 3 + c] * l / 255, 0.0, 255.0);
        squares += std::pow(static_cast<double>(pixel.color.out[c]) - right, 2);
      }
    }
  }
  picture.rmse = std::sqrt(squares / static_cast<double>(map.color.size() * lights.size()));
  return picture;
}

TEST(BalanceLuminance, MakesSaturationRareOnPaper8AndThePictureBetter) {
  const BrightMap truth = bright_map(400);
  const Lights lights = grid_of_lights();
  BrightMap balanced = truth;
  (void)balance_luminance(balanced.coef, balanced.color, lights, reference::kPaper8);
  const Picture before = render(truth, truth, lights), after = render(balanced, truth, lights);
  std::cout << "paper8: luminance saturated " << before.saturated << " -> " << after.saturated
            << ", picture off by " << before.rmse << " -> " << after.rmse << " levels RMS\n";
  EXPECT_GT(before.saturated, 3000U);
  EXPECT_LT(after.saturated, before.saturated / 50);
  EXPECT_LT(after.rmse, before.rmse / 4);
}

TEST(BalanceLuminance, RefusesWhatDoesNotFitTogether) {
  std::vector<double> coef(6, 1.0);
  std::vector<std::uint8_t> color(3), longer(4);
  EXPECT_THROW((void)balance_luminance(coef, color, {}, reference::kBase), std::invalid_argument);
  EXPECT_THROW((void)balance_luminance(coef, longer, Lights{{0, 0}}, reference::kBase),
               std::invalid_argument);
  coef[2] = NAN;
  EXPECT_THROW((void)balance_luminance(coef, color, Lights{{0, 0}}, reference::kBase),
               std::invalid_argument);
}

}  // namespace
}  // namespace ptm::quantize
