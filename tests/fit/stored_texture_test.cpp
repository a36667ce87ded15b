#include "testbench/run/stored_texture.h"

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

TEST(StoreTexture, TakesAFileThatFitsVerbatimAndGivesItBackUnchanged) {
  for (const auto kind : {golden::MapKind::lrgb, golden::MapKind::rgb}) {
    const golden::PtmMap map = random_map(kind, 2);
    const StoredTexture texture =
        store_texture(map, reference::kBase, quantize::Method::nearest_plane);
    EXPECT_EQ(texture.why_not_verbatim, "");
    EXPECT_EQ(texture.map.origin, quantize::Origin::verbatim);
    EXPECT_EQ(to_ptm(texture.map, kind, map.color), map);
  }
}

TEST(StoreTexture, QuantisesAFileWithRealScalesAndSaysWhy) {
  golden::PtmMap map = random_map(golden::MapKind::lrgb, 1.7);
  map.bias[0] = -715;
  const StoredTexture texture =
      store_texture(map, reference::kBase, quantize::Method::nearest_plane);
  EXPECT_NE(texture.why_not_verbatim.find("scale 0 is 1.7"), std::string::npos);
  EXPECT_EQ(texture.map.origin, quantize::Origin::nearest_plane);
  const std::vector<double> stored = quantize::dequantize(texture.map);
  double worst = 0;
  for (std::size_t k = 0; k < stored.size(); k += 6) {
    worst = std::max(worst, std::abs(stored[k + 5] - map.coef[k + 5] * 1.7));
  }
  EXPECT_LE(worst, 1);  // 0..433 in 256 steps: a step of 2, half of it
}

TEST(ToPtm, RefusesCoefficientsOfMoreThanEightBits) {
  quantize::StoredMap wide{.width = 1, .height = 1, .polynomials = 1};
  wide.coef = {0, 1, 2, 3, 4, 256};
  EXPECT_THROW((void)to_ptm(wide, golden::MapKind::lrgb, {0, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace ptm::testbench
