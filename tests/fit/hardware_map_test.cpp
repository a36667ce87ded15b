#include "testbench/run/hardware_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace ptm::testbench {
namespace {

golden::PtmMap random_map(golden::MapKind kind, double scale) {
  golden::PtmMap map;
  map.kind = kind;
  map.width = 6;
  map.height = 5;
  map.scale.fill(scale);
  map.bias = {149, 151, 68, 77, 77, 0};
  map.coef.resize(map.texels() * map.polynomials() * 6);
  map.color.resize(map.texels() * map.color_bytes());
  std::mt19937 random(12);
  for (auto& byte : map.coef) byte = static_cast<std::uint8_t>(random());
  for (auto& byte : map.color) byte = static_cast<std::uint8_t>(random());
  return map;
}

/// The real coefficient that a texture's integers stand for.
double real_value(const reference::StoredTexture& texture, std::size_t index) {
  const std::size_t k = index % 6;
  return std::ldexp(static_cast<double>(texture.coef[index] - texture.bias[k]),
                    -static_cast<int>(texture.shift[k]));
}

TEST(StoreMap, TakesAFileThatFitsVerbatim) {
  for (const auto kind : {golden::MapKind::lrgb, golden::MapKind::rgb}) {
    const golden::PtmMap map = random_map(kind, 2);
    const HardwareMap hardware = store_map(map, reference::kBase);
    EXPECT_EQ(hardware.origin, quantize::Origin::verbatim);
    EXPECT_EQ(hardware.texture.rgb, kind == golden::MapKind::rgb);
    EXPECT_TRUE(std::equal(map.coef.begin(), map.coef.end(), hardware.texture.coef.begin(),
                           hardware.texture.coef.end()));
    EXPECT_EQ(hardware.texture.color, map.color);
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_EQ(hardware.texture.bias[k], map.bias[k]);
      EXPECT_EQ(hardware.texture.shift[k], -1);
    }
  }
}

TEST(StoreMap, QuantisesAFileWithRealScalesAndSaysWhy) {
  golden::PtmMap map = random_map(golden::MapKind::lrgb, 1.7);
  map.bias[0] = -715;
  std::fill(map.color.begin(), map.color.end(), std::uint8_t{255});  // no room for luminance
  const HardwareMap hardware = store_map(map, reference::kBase);
  EXPECT_NE(hardware.how.find("scale 0 is 1.7"), std::string::npos) << hardware.how;
  EXPECT_EQ(hardware.origin, quantize::Origin::nearest_plane);
  double worst = 0;
  for (std::size_t k = 5; k < map.coef.size(); k += 6) {
    worst = std::max(worst, std::abs(real_value(hardware.texture, k) - map.coef[k] * 1.7));
  }
  EXPECT_LE(worst, 1);  // 0..433 in 256 steps: a step of 2, half of it
}

TEST(StoreMap, MovesLuminanceBeyondTheHardwaresIntoColour) {
  golden::PtmMap map = random_map(golden::MapKind::lrgb, 1.7);
  map.bias[0] = -715;
  std::fill(map.color.begin(), map.color.end(), std::uint8_t{50});
  const HardwareMap hardware = store_map(map, reference::kBase);
  EXPECT_NE(hardware.how.find("colours"), std::string::npos) << hardware.how;
  EXPECT_NE(hardware.texture.color, map.color);
  for (std::size_t t = 0; t < map.texels(); ++t) {
    const double color = hardware.texture.color[t * 3],
                 a5 = real_value(hardware.texture, t * 6 + 5);
    EXPECT_NEAR(color * a5 / 255, 50 * (map.coef[t * 6 + 5] * 1.7) / 255, 0.5) << t;
  }
}

TEST(StoreMap, RunsALumMapAsAnRgbMapOfSums) {
  golden::PtmMap map = random_map(golden::MapKind::lum, 0.25);
  map.lum_matrix = {1, 1, 0, -128, -0.5, 1, -0.25, 96, 0, 1, 2, -256, 0, 0, 0, 1};
  const HardwareMap hardware = store_map(map, reference::kBase);
  ASSERT_TRUE(hardware.texture.rgb);
  const RealCoefficients real = real_polynomials(map);
  const double cr = map.color[2], cb = map.color[3];  // the second texel's
  const double a5 = (map.coef[11] - map.bias[5]) * 0.25;
  EXPECT_DOUBLE_EQ(real.coef[18 + 5], a5 + cr - 128);
  EXPECT_DOUBLE_EQ(real.coef[18 + 11], a5 - 0.5 * cr - 0.25 * cb + 96);
  EXPECT_DOUBLE_EQ(real.coef[18 + 17], a5 + 2 * cb - 256);
  EXPECT_DOUBLE_EQ(real.coef[18 + 6], (map.coef[6] - map.bias[0]) * 0.25);
}

TEST(RgbPolynomials, OfAnLrgbMapHaveItsColourMultipliedIn) {
  const golden::PtmMap map = random_map(golden::MapKind::lrgb, 2);
  const RealCoefficients rgb = rgb_polynomials(map);
  EXPECT_EQ(rgb.polynomials, 3U);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_DOUBLE_EQ(rgb.coef[c * 6 + 4], (map.coef[4] - 77) * 2.0 * map.color[c] / 255);
  }
}

TEST(ToPtm, GivesAFileThatIsTakenVerbatim) {
  quantize::StoredMap stored{.width = 1, .height = 1, .polynomials = 1};
  stored.coef = {0, 1, 2, 3, 4, 255};
  stored.bias = {9, 8, 7, 6, 5, 0};
  stored.shift = {-1, 0, 1, 2, 3, -2};
  const HardwareMap hardware =
      store_map(to_ptm(stored, golden::MapKind::lrgb, {1, 2, 3}), reference::kBase);
  EXPECT_EQ(hardware.origin, quantize::Origin::verbatim) << hardware.how;
  EXPECT_EQ(hardware.texture.coef, stored.coef);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(hardware.texture.bias[k], stored.bias[k]);
    EXPECT_EQ(hardware.texture.shift[k], stored.shift[k]);
  }
}

TEST(ToPtm, RefusesCoefficientsOfMoreThanEightBits) {
  quantize::StoredMap wide{.width = 1, .height = 1, .polynomials = 1};
  wide.coef = {0, 1, 2, 3, 4, 256};
  EXPECT_THROW((void)to_ptm(wide, golden::MapKind::lrgb, {0, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace ptm::testbench
