#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "golden/effects/map_normals.h"
#include "golden/files/input_error.h"
#include "golden/files/ptm_file.h"
#include "golden/fit/hp_quantizer.h"
#include "golden/render/area_average.h"
#include "golden/render/light_map.h"
#include "golden/render/texture_filter.h"

namespace ptm::golden {
namespace {

PtmMap one_texel(MapKind kind, double scale, std::vector<std::uint8_t> coef) {
  PtmMap map;
  map.kind = kind;
  map.width = map.height = 1;
  map.scale.fill(scale);
  map.bias.fill(100);
  map.coef = std::move(coef);
  map.color.assign(map.color_bytes(), 128);
  return map;
}

TEST(FarLuminance, SaturatesOnTheSideOfTheExactValue) {
  constexpr double most = std::numeric_limits<double>::max();
  // u^2 alone is beyond the doubles, and its difference with v^2 is inf - inf.
  EXPECT_EQ(luminance({1, -1, 0, 0, 0, 0}, 2e154, 1e154), most);
  EXPECT_EQ(luminance({1, -1, 0, 0, 0, 0}, 1e200, 2e200), -most);
  EXPECT_EQ(luminance({-3, 0, 0, 0, 0, 255}, 1e160, 0), -most);
  // Exactly equal squares leave the rest: 7 of the linear part, or the constant.
  EXPECT_EQ(luminance({1, -1, 0, 0, 0, 40}, 1e200, 1e200), 40);
  EXPECT_EQ(luminance({0, 0, 1e308, 0, 0, 0}, 1e200, 1e200), most);
  EXPECT_EQ(luminance({0, 0, -1e308, 0, 0, 0}, 1e308, 1e308), -most);
  EXPECT_EQ(luminance({1e308, 1e308, 0, 0, 0, -1e308}, 1, 1), 1e308);
}

TEST(FarLuminance, LeavesNoNumberThatIsNoneInAnyKindOfMap) {
  // Coefficients of both signs up to 2e305, and lights of every size; a colour of 0 among them.
  for (const MapKind kind : {MapKind::lrgb, MapKind::rgb, MapKind::lum}) {
    for (const double scale : {1.0, 1e12, 1e200, 1e303}) {
      for (const double size : {1.0, 1e100, 1e154, 1e200, 1.7e308}) {
        PtmMap map = one_texel(kind, scale, {});
        for (std::size_t k = 0; k < 6 * map.polynomials(); ++k) {
          map.coef.push_back(static_cast<std::uint8_t>(k % 2 == 0 ? 255 : 0));
        }
        if (!map.color.empty()) map.color[0] = 0;
        map.lum_matrix.fill(-0.5);
        for (const double u : {size, -size, 0.0}) {
          for (const double level : light_texel(map, 0, u, size)) {
            EXPECT_TRUE(level >= 0 && level <= 255) << level << ", scale " << scale << ", " << size;
          }
        }
      }
    }
  }
}

TEST(FarLuminance, OfAHugeScaleIsBlackOrWhiteAsTheExactValueIs) {
  // (255 - 100) 1e303 and (0 - 100) 1e303 as the constant: white and black, colour 128 or 1 alike.
  for (const std::uint8_t color : {std::uint8_t{1}, std::uint8_t{128}}) {
    for (const auto& [byte, level] : {std::pair{255, 255.0}, {0, 0.0}}) {
      PtmMap map = one_texel(MapKind::lrgb, 1e303, {100, 100, 100, 100, 100, 0});
      map.coef[5] = static_cast<std::uint8_t>(byte);
      map.color.assign(3, color);
      EXPECT_EQ(light_texel(map, 0, 0.3, 0.4), (Rgb{level, level, level}));
    }
  }
}

std::string complaint_of(const PtmMap& map) {
  try {
    (void)parse_ptm(format_ptm(map), "a.ptm");
    return "taken";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(FarScales, AreRefusedWhereACoefficientIsNoDouble) {
  PtmMap map = one_texel(MapKind::lrgb, 1, {1, 2, 3, 4, 5, 6});
  map.scale[2] = -1e308;
  EXPECT_EQ(complaint_of(map).find(
                "a.ptm: line 6 (scales and biases): found scale 2 of -1e+308 with bias 100"),
            0U)
      << complaint_of(map);
  // The greatest byte less bias is 155: the limit is the largest double's 155th part.
  map.scale[2] = std::numeric_limits<double>::max() / 155;
  EXPECT_EQ(complaint_of(map), "taken");
  map.scale[2] *= 1.001;
  EXPECT_NE(complaint_of(map), "taken");
  map.scale[2] = 1e300;
  map.bias[2] = std::numeric_limits<std::int32_t>::min();
  EXPECT_NE(complaint_of(map), "taken");
}

TEST(FarScales, AreRefusedOnOneLineWithTheBiasesToo) {
  const std::string text = "PTM_1.2\nPTM_FORMAT_LRGB\n1\n1\n1 1 1 1 1 1e308 9 9 9 9 9 9\n123456789";
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  EXPECT_THROW((void)parse_ptm(bytes, "a.ptm"), InputError);
}

TEST(FarScales, OfALumMapAreRefusedWhereItsMatrixMakesNoDoubleOfThem) {
  PtmMap map = one_texel(MapKind::lum, 1e200, {1, 2, 3, 4, 5, 6});
  map.lum_matrix.fill(1);
  EXPECT_EQ(complaint_of(map), "taken");
  map.lum_matrix[5] = 1e107;
  EXPECT_NE(complaint_of(map).find("colour matrix"), std::string::npos) << complaint_of(map);
}

TEST(FarNumbers, MakeNoPictureOfWhatIsNoNumber) {
  ImageReal image(1, 1, 3);
  image.samples = {300, -4, 127.5};
  EXPECT_EQ(to_8_bit(image).samples, (std::vector<std::uint8_t>{255, 0, 128}));
  EXPECT_EQ(to_8_bit(image, Rounding8::truncate).samples, (std::vector<std::uint8_t>{255, 0, 127}));
  image.samples[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)to_8_bit(image), std::invalid_argument);
}

TEST(FarNumbers, KeepTheDirectionOfTheBrightestLight) {
  const Coefficients usual{-80, -60, 10, 40, -20, 100};
  const Peak peak = brightest_light(usual);
  const auto normal = normal_of(usual, peak);
  ASSERT_EQ(peak.kind, PeakKind::inside);
  for (const double size : {1e-300, 1e-170, 1e170, 1e300}) {
    Coefficients a = usual;
    for (double& number : a) number *= size;
    const Peak found = brightest_light(a);
    EXPECT_EQ(found.kind, peak.kind) << size;
    EXPECT_NEAR(found.light[0], peak.light[0], 1e-14) << size;
    EXPECT_NEAR(found.light[1], peak.light[1], 1e-14) << size;
    const auto there = normal_of(a, {{0, 0}, PeakKind::flat});
    const auto here = normal_of(usual, {{0, 0}, PeakKind::flat});
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(there[k], here[k], 1e-14) << size;
  }
  EXPECT_GT(normal[2], 0);
}

TEST(FarNumbers, OfRangesGiveAGridThatHoldsThem) {
  // Less than the smallest usual number apart: the scale must not become 0.
  CoefficientRange range;
  range.low.fill(-0x1p-1074);
  range.high.fill(0);
  for (const double scale : hp_grid(range).scale) EXPECT_GT(scale, 0);
}

TEST(FarNumbers, BeyondAClampedEdgeAverageTheEdge) {
  LoadedTexture texture;
  texture.polynomials = 0;
  texture.width = 4;
  texture.height = 1;
  for (int n = 0; n < 4; ++n) texture.rgba.insert(texture.rgba.end(), 4, 10.0 * n);
  const MipTexture mips(texture, false);
  for (const double u : {5.0, 1e13, 1e16, 1e40}) {
    const PixelFootprint footprint{
        .u = u, .v = -u, .dudx = 0.5, .dvdx = 0.25, .dudy = -0.25, .dvdy = 0.5};
    EXPECT_NEAR(area_average(mips, footprint, WrapMode::clamp, WrapMode::clamp, {})[0], 30, 1e-12)
        << u;
  }
}

}  // namespace
}  // namespace ptm::golden
