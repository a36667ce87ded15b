#include "golden/render/light_map.h"

#include <gtest/gtest.h>

#include "golden/files/picture_file.h"
#include "golden/files/ptm_file.h"
#include "golden/scene/flat_samples.h"
#include "tests/shared_data.h"

namespace ptm::golden {
namespace {

PtmMap one_texel(MapKind kind) {
  PtmMap map;
  map.kind = kind;
  map.width = map.height = 1;
  map.scale = {2, 2, 2, 2, 2, 2};
  map.bias = {10, 20, 30, 40, 50, 0};
  return map;
}

TEST(LightMap, FollowsEquationFiveInOrderOfTheCoefficients) {
  PtmMap map = one_texel(MapKind::lrgb);
  map.coef = {11, 22, 33, 44, 55, 60};  // a = 2 4 6 8 10 120
  map.color = {255, 51, 0};
  const double l = 2 * 0.25 + 4 * 0.0625 + 6 * -0.125 + 8 * 0.5 + 10 * -0.25 + 120;
  EXPECT_DOUBLE_EQ(luminance(real_coefficients(map, 0), 0.5, -0.25), l);
  const Rgb color = light_texel(map, 0, 0.5, -0.25);
  EXPECT_DOUBLE_EQ(color[0], l);
  EXPECT_DOUBLE_EQ(color[1], l / 5);
  EXPECT_DOUBLE_EQ(color[2], 0);
}

TEST(LightMap, DoesNotClampLuminanceBeforeTheColour) {
  PtmMap map = one_texel(MapKind::lrgb);
  map.coef = {10, 20, 30, 40, 50, 255};  // L = 510 everywhere
  map.color = {100, 200, 0};
  const Rgb color = light_texel(map, 0, 0.1, 0.2);
  EXPECT_DOUBLE_EQ(color[0], 200) << "half of what clamping L to 255 first would give";
  EXPECT_DOUBLE_EQ(color[1], 255);
}

TEST(LightMap, ClampsANegativeLuminanceToBlack) {
  PtmMap map = one_texel(MapKind::rgb);
  map.coef = {10, 20, 30, 40, 50, 7, 10, 20, 30, 40, 0, 0, 10, 20, 30, 41, 50, 200};
  const Rgb color = light_texel(map, 0, 0.5, 0.5);
  EXPECT_DOUBLE_EQ(color[0], 14);
  EXPECT_DOUBLE_EQ(color[1], 0);
  EXPECT_DOUBLE_EQ(color[2], 255);
}

TEST(LightMap, MultipliesALumMapsVectorInTheOrderCrYCb) {
  PtmMap map = one_texel(MapKind::lum);
  map.coef = {10, 20, 30, 40, 50, 50};  // Y = 100
  map.color = {128, 64};                // Cr, Cb
  map.lum_matrix = {0.5, 1, 0, -64, 0, 1, 0.25, 0, 0, 0.5, 1, 6, 0, 0, 0, 1};
  const Rgb color = light_texel(map, 0, 0, 0);
  EXPECT_DOUBLE_EQ(color[0], 100);
  EXPECT_DOUBLE_EQ(color[1], 116);
  EXPECT_DOUBLE_EQ(color[2], 120);
}

TEST(To8Bit, RoundsOrTruncatesAndNeverWraps) {
  ImageReal image(4, 1, 1);
  image.samples = {0.5, 1.4999, 254.5, 255};
  EXPECT_EQ(to_8_bit(image).samples, (std::vector<std::uint8_t>{1, 1, 255, 255}));
  EXPECT_EQ(to_8_bit(image, Rounding8::truncate).samples,
            (std::vector<std::uint8_t>{0, 1, 254, 255}));
}

TEST(FlatSamples, OfAMapsOwnSizeReadEveryTexelOnce) {
  PtmMap map = one_texel(MapKind::lrgb);
  map.width = 402;
  map.height = 395;
  std::size_t expected = 0;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      ASSERT_EQ(nearest_texel(map, flat_sample(x, y, map.width, map.height, {})), expected++);
    }
  }
}

/// Two other programs' pictures of a real file at light (-1, 0).
class Tablet : public testing::Test {
 protected:
  void compare(const char* picture, Rounding8 rounding, int tolerance, std::size_t differing) {
    PTM_SHARED_DATA_OR_SKIP(folder, "tablet2");
    const PtmFile file = read_ptm(folder / "tablet2_LRGB.ptm");
    const Image8 ours = to_8_bit(light_map(file.map, -1, 0), rounding);
    const ImageReal theirs = read_picture(folder / picture);
    ASSERT_EQ(theirs.samples.size(), 786432U);
    ASSERT_EQ(theirs.samples.size(), ours.samples.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < ours.samples.size(); ++i) {
      const int error = std::abs(ours.samples[i] - static_cast<int>(theirs.samples[i]));
      ASSERT_LE(error, tolerance) << "sample " << i;
      different += error != 0 ? 1 : 0;
    }
    EXPECT_LE(different, differing);
  }
};

TEST_F(Tablet, EqualsRtiViewersPictureInEverySample) {
  compare("tablet2_LRGB_RTIViewer.png", Rounding8::truncate, 0, 0);
}

TEST_F(Tablet, IsWithinOneLevelOfOxrtisRoundedPicture) {
  // The other program computes in single precision on a GPU; ties may fall either way.
  compare("tablet2_LRGB_full.png", Rounding8::nearest, 1, 78);  // 0.01 %
}

}  // namespace
}  // namespace ptm::golden
