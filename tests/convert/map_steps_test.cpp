#include "testbench/run/map_steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "golden/render/light_map.h"
#include "model/quantize/mip.h"
#include "testbench/compare/lit_difference.h"
#include "testbench/run/hardware_map.h"
#include "tests/convert/made_maps.h"

namespace ptm::testbench {
namespace {

using golden::MapKind;
using golden::PtmMap;
using tests::smooth_map;

bool verbatim(const PtmMap& map, const reference::EvalConfig& config) {
  return import_map(map, config).map.has_value();
}

TEST(HoldMap, LeavesAMapThatIsTakenVerbatimAndMakesOthersSo) {
  const PtmMap map = smooth_map(MapKind::lrgb, 20, 15);
  EXPECT_EQ(hold_map(map, reference::kBase, quantize::Dither::diffused).map, map);
  PtmMap odd = map;
  odd.scale[3] = 1.3;
  for (const auto& [name, config] : reference::kPresets) {
    const SteppedMap held = hold_map(odd, config, quantize::Dither::none);
    EXPECT_TRUE(verbatim(held.map, config)) << name;
    EXPECT_NE(held.how.find("scale 3 is 1.3"), std::string::npos) << held.how;
    EXPECT_LT(compare_lit(odd, held.map, comparison_lights()).rmse, 1) << name;
  }
}

TEST(HoldMap, ScalesColorUpWherePaper8CouldNotHoldTheLuminance) {
  PtmMap map = smooth_map(MapKind::lrgb, 16, 16);
  map.scale.fill(1.7);  // luminance to about 330
  for (auto& c : map.color) c = static_cast<std::uint8_t>(c / 2);
  const SteppedMap held = hold_map(map, reference::kPaper8, quantize::Dither::none);
  EXPECT_NE(held.how.find("colour scaled up"), std::string::npos) << held.how;
  double most = 0;
  for (std::size_t t = 0; t < map.texels(); ++t) {
    for (const auto& [lu, lv] : hemisphere_lights()) {
      most = std::max(most, golden::luminance(golden::real_coefficients(held.map, t), lu, lv));
    }
  }
  EXPECT_LT(most, 260);
  EXPECT_LT(compare_lit(map, held.map, comparison_lights()).rmse, 1);
}

TEST(ToRgbMap, LightsAsTheLrgbAndLumMapsDid) {
  for (const MapKind kind : {MapKind::lrgb, MapKind::lum}) {
    const PtmMap map = smooth_map(kind, 24, 17);
    const SteppedMap rgb = to_rgb_map(map, reference::kBase, quantize::Dither::none);
    EXPECT_EQ(rgb.map.kind, MapKind::rgb);
    EXPECT_TRUE(verbatim(rgb.map, reference::kBase));
    const LitDifference lit = compare_lit(map, rgb.map, comparison_lights());
    EXPECT_LT(lit.rmse, 0.6);
    EXPECT_LT(lit.max, 3);
  }
  const PtmMap rgb = smooth_map(MapKind::rgb, 5, 4);
  EXPECT_EQ(to_rgb_map(rgb, reference::kBase, quantize::Dither::none).map, rgb);
}

TEST(PaletteMap, HasNoMoreDifferentPolynomialsThanAskedForAndIsTheSameEachTime) {
  for (const MapKind kind : {MapKind::lrgb, MapKind::rgb}) {
    const PtmMap map = smooth_map(kind, 40, 40);
    const SteppedMap palette = palette_map(map, reference::kBase, {.entries = 50});
    EXPECT_EQ(palette.map, palette_map(map, reference::kBase, {.entries = 50}).map);
    EXPECT_TRUE(verbatim(palette.map, reference::kBase));
    std::set<std::vector<std::uint8_t>> different;
    const std::size_t stride = 6 * map.polynomials();
    for (std::size_t k = 0; k < palette.map.coef.size(); k += stride) {
      const auto at = palette.map.coef.begin() + static_cast<std::ptrdiff_t>(k);
      different.insert({at, at + static_cast<std::ptrdiff_t>(stride)});
    }
    EXPECT_LE(different.size(), 50U);
    EXPECT_GT(different.size(), 40U);
    EXPECT_LT(compare_lit(map, palette.map, comparison_lights()).rmse, 6);
  }
}

TEST(PaletteMap, HoldsABlackMap) {
  PtmMap map = smooth_map(MapKind::lrgb, 6, 6);
  std::fill(map.color.begin(), map.color.end(), std::uint8_t{0});
  const SteppedMap palette = palette_map(map, reference::kBase, {.entries = 4});
  EXPECT_EQ(compare_lit(map, palette.map, comparison_lights()).max, 0);
}

TEST(MipChain, EndsInOneTexelOnOneGridAndLightsLikeTheAverageOfLitTexels) {
  const PtmMap map = smooth_map(MapKind::rgb, 37, 20);
  const std::vector<PtmMap> chain = mip_chain(map, reference::kBase);
  ASSERT_EQ(chain.size(), 6U);  // 37 18 9 4 2 1
  EXPECT_EQ(chain.front(), map);
  EXPECT_EQ(chain.back().texels(), 1U);
  golden::ImageReal lit = golden::light_map(map, 0.3, -0.5);  // nothing is clamped here
  for (std::size_t level = 1; level < chain.size(); ++level) {
    EXPECT_EQ(chain[level].scale, map.scale);
    EXPECT_EQ(chain[level].bias, map.bias);
    lit.samples = quantize::halve(lit.samples, lit.width, lit.height, 3);
    lit.width = chain[level].width;
    lit.height = chain[level].height;
    const golden::ImageReal own = golden::light_map(chain[level], 0.3, -0.5);
    for (std::size_t i = 0; i < lit.samples.size(); ++i) {
      ASSERT_NEAR(own.samples[i], lit.samples[i], 1.5) << level;  // steps of 1, six of them
    }
  }
}

TEST(MipChain, AveragesColorsFromTheFirstLevelWithoutRoundingBetween) {
  PtmMap map = smooth_map(MapKind::lrgb, 4, 4);
  for (std::size_t t = 0; t < 16; ++t) map.color[t * 3] = t == 0 ? 9 : 0;  // mean 0.5625
  const std::vector<PtmMap> chain = mip_chain(map, reference::kBase);
  EXPECT_EQ(chain[1].color[0], 2);  // 2.25
  EXPECT_EQ(chain[2].color[0], 1);  // 0.5625, but 2 / 4 = 0.5 would do as well: so also
  map.color[0] = 7;                 // 1.75 -> 2, 0.4375 -> 0 and not round(2 / 4)
  EXPECT_EQ(mip_chain(map, reference::kBase)[2].color[0], 0);
}

}  // namespace
}  // namespace ptm::testbench
