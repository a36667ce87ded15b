// Maps made of picture sequences, and the other grounds that effects show themselves on.
#include "golden/scene/image_stack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "golden/effects/map_normals.h"
#include "golden/render/light_map.h"
#include "golden/scene/generate.h"
#include "golden/scene/tablet.h"

namespace ptm::golden {
namespace {

TextureSpec pattern(const std::string& name, int width, int height) {
  TextureSpec spec;
  spec.name = spec.pattern = name;
  spec.size = {width, height};
  return spec;
}

/// RMS difference of a map at lu, lv and a picture.
double difference(const LoadedTexture& map, double lu, double lv, const StackPicture& picture) {
  double squares = 0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    Coefficients a{};
    std::copy_n(&map.coef[i * 6], 6, a.begin());
    const double level = std::clamp(luminance(a, lu, lv), 0.0, 255.0);
    squares += (level - picture[i]) * (level - picture[i]);
  }
  return std::sqrt(squares / static_cast<double>(picture.size()));
}

TEST(FocusStack, IsSharpWhereItsPicturesAre) {
  const TextureSpec spec = pattern("focus", 96, 96);
  const auto pictures = focus_pictures(spec);
  ASSERT_EQ(pictures.size(), 8U);
  const LoadedTexture map = generate_texture(spec);
  EXPECT_EQ(map.polynomials, 3);
  for (std::size_t n = 0; n < pictures.size(); ++n) {
    const double s = 2.0 * static_cast<double>(n) / 7 - 1;
    EXPECT_LT(difference(map, s, 0, pictures[n]), 12) << n;
    for (std::size_t other = 0; other < pictures.size(); ++other) {
      if (std::abs(static_cast<int>(other) - static_cast<int>(n)) < 2) continue;
      EXPECT_LT(difference(map, s, 0, pictures[n]), difference(map, s, 0, pictures[other]));
    }
    EXPECT_EQ(difference(map, s, 0.7, pictures[n]), difference(map, s, 0, pictures[n]))
        << "the second parameter has no say";
  }
}

TEST(Tide, FallsFromMorningToEvening) {
  const TextureSpec spec = pattern("tide", 48, 36);
  const auto pictures = tide_pictures(spec);
  ASSERT_EQ(pictures.size(), 40U);
  const LoadedTexture map = generate_texture(spec);
  double squares = 0;
  for (std::size_t n = 0; n < pictures.size(); ++n) {
    squares += std::pow(difference(map, 2.0 * static_cast<double>(n) / 39 - 1, 0, pictures[n]), 2);
  }
  EXPECT_LT(std::sqrt(squares / 40), 16);
  EXPECT_LT(difference(map, -1, 0, pictures.front()), difference(map, -1, 0, pictures.back()) / 2);
  EXPECT_LT(difference(map, 1, 0, pictures.back()), difference(map, 1, 0, pictures.front()) / 2);
}

TEST(Tablet, HasTheNormalsOfItsHeightsWhereItIsFittedWell) {
  const TextureSpec spec = pattern("tablet", 128, 128);
  const LoadedTexture map = generate_texture(spec);
  const MapNormals normals = map_normals(map);
  EXPECT_GT(normals.without_maximum, 0U);
  EXPECT_LT(normals.without_maximum, map.texels() / 4);
  std::vector<double> angles;
  const double step = 1.0 / 128;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      const double px = 2 * (x + 0.5) / 128 - 1, py = 1 - 2 * (y + 0.5) / 128;
      const double dx = (tablet_height(1, px + step, py) - tablet_height(1, px - step, py));
      const double dy = (tablet_height(1, px, py + step) - tablet_height(1, px, py - step));
      const Vec3 truth = Vec3(-dx / (2 * step), -dy / (2 * step), 1).normalized();
      const auto& n = normals.field.normals[static_cast<std::size_t>(y * 128 + x)];
      angles.push_back(std::acos(std::min(1.0, truth.dot(Vec3(n[0], n[1], n[2])))));
    }
  }
  std::nth_element(angles.begin(), angles.begin() + 8192, angles.end());
  EXPECT_LT(angles[8192] * 180 / std::numbers::pi, 6) << "median angle";
}

TEST(EffectGrounds, AreFlatAndAGlossMapIsSteady) {
  const LoadedTexture gloss = generate_texture(pattern("gloss", 24, 24));
  const LoadedTexture disc = generate_texture(pattern("disc", 24, 24));
  const LoadedTexture metal = generate_texture(pattern("metal", 24, 24));
  for (std::size_t t = 0; t < gloss.texels(); ++t) {
    for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(gloss.coef[t * 6 + k], 0);
    EXPECT_EQ(gloss.coef[t * 6 + 5], 255);
    EXPECT_NEAR(disc.coef[t * 6 + 3], 0, 1e-9);
    EXPECT_NEAR(metal.coef[t * 6 + 4], 0, 1e-9);
    EXPECT_LT(disc.coef[t * 6], 0) << "brighter under higher lights";
  }
  EXPECT_EQ(disc.color[0], 0) << "nothing beyond the rim";
  EXPECT_GT(disc.color[(12 * 24 + 4) * 3], 0);
}

}  // namespace
}  // namespace ptm::golden
