#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "golden/files/picture_file.h"
#include "golden/files/ptm_file.h"
#include "tests/shared_data.h"

// Files that other programs wrote.
namespace ptm::golden {
namespace {

TEST(RealFiles, Tablet2HasTheHeaderThatItsMakersWrote) {
  PTM_SHARED_DATA_OR_SKIP(path, "tablet2/tablet2_LRGB.ptm");
  const PtmFile file = read_ptm(path);
  EXPECT_EQ(file.info.format, "PTM_FORMAT_LRGB");
  EXPECT_EQ(file.map.width, 512);
  EXPECT_EQ(file.map.height, 512);
  EXPECT_EQ(file.map.scale, (std::array<double, 6>{2, 2, 2, 2, 2, 2}));
  EXPECT_EQ(file.map.bias, (std::array<std::int32_t, 6>{149, 151, 68, 77, 77, 0}));
  EXPECT_EQ(file.info.file_bytes, 105U + 512 * 512 * 9);
}

TEST(RealFiles, Tablet2LitFromTheLeftIsRtiViewersPictureOrientationIncluded) {
  PTM_SHARED_DATA_OR_SKIP(path, "tablet2/tablet2_LRGB.ptm");
  PTM_SHARED_DATA_OR_SKIP(picture_path, "tablet2/tablet2_LRGB_RTIViewer.png");
  const PtmMap map = read_ptm(path).map;
  const ImageReal picture = read_picture(picture_path);
  ASSERT_EQ(picture.width, map.width);
  ASSERT_EQ(picture.height, map.height);
  std::size_t differing = 0;
  for (std::size_t texel = 0; texel < map.texels(); ++texel) {
    const auto a = [&](std::size_t k) {
      return (map.coef[6 * texel + k] - map.bias[k]) * map.scale[k];
    };
    const double luminance = a(0) - a(3) + a(5);  // (u, v) = (-1, 0)
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = map.color[3 * texel + c] * luminance / 255;
      const double shown = std::floor(std::clamp(value, 0.0, 255.0));
      const auto channels = static_cast<std::size_t>(picture.channels);
      differing += shown == picture.samples[channels * texel + (channels == 3 ? c : 0)] ? 0U : 1U;
    }
  }
  EXPECT_EQ(differing, 0U);
}

TEST(RealFiles, UshabtiDecodesWithInvertedPlanesThatStayInRange) {
  PTM_SHARED_DATA_OR_SKIP(path, "ushabti/ushabti.ptm");
  const PtmFile file = read_ptm(path);
  EXPECT_EQ(file.info.format, "PTM_FORMAT_JPEG_LRGB");
  EXPECT_EQ(file.map.width, 512);
  EXPECT_EQ(file.map.height, 1024);
  EXPECT_EQ(file.info.order, (std::vector<int>{8, 4, 3, 2, 1, 7, 5, 0, 6}));
  EXPECT_EQ(file.info.references, (std::vector<int>{5, -1, -1, -1, -1, 1, 7, -1, 7}));
  EXPECT_EQ(file.info.transforms, (std::vector<int>{1, 0, 0, 0, 0, 1, 0, 0, 0}));
  EXPECT_TRUE(file.info.notes.empty());
  // Neighbours in a row are alike in every plane; one wrong plane of the chain would be far off.
  const std::size_t row = 512 * 6;
  for (std::size_t k = 0; k < 6; ++k) {
    double steps = 0;
    for (std::size_t i = row + k; i < file.map.coef.size(); i += 6) {
      steps += std::abs(file.map.coef[i] - file.map.coef[i - row]);
    }
    EXPECT_LT(steps / static_cast<double>(file.map.texels()), 16) << "a" << k;
  }
}

TEST(RealFiles, HpFittersBlankAfterTheSixthNumberIsRead) {
  PTM_SHARED_DATA_OR_SKIP(path, "reference_8x5/reference_8x5.ptm");
  const PtmMap map = read_ptm(path).map;
  EXPECT_EQ(map.scale, (std::array<double, 6>{0.5, 0.5, 0.25, 0.5, 0.25, 1}));
  EXPECT_EQ(map.bias, (std::array<std::int32_t, 6>{167, 97, 0, 0, 0, 0}));
  // The payload begins with 0x50 0x4b, at the bottom left texel.
  EXPECT_EQ(map.coef[4 * 8 * 6], 0x50);
  EXPECT_EQ(map.coef[4 * 8 * 6 + 1], 0x4b);
}

TEST(RealFiles, EveryCodingOfThemReadsBackIdentically) {
  for (const char* name : {"tablet2/tablet2_LRGB.ptm", "ushabti/ushabti.ptm"}) {
    PTM_SHARED_DATA_OR_SKIP(path, name);
    const PtmMap map = read_ptm(path).map;
    for (const PtmWriteOptions& options :
         {PtmWriteOptions{}, PtmWriteOptions{.version_1_1 = true},
          PtmWriteOptions{.coding = Coding::jpeg}, PtmWriteOptions{.coding = Coding::jpegls}}) {
      EXPECT_TRUE(parse_ptm(format_ptm(map, options), "written").map == map) << name;
    }
  }
}

}  // namespace
}  // namespace ptm::golden
