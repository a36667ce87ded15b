#include "golden/render/texture_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "golden/render/area_average.h"
#include "golden/scene/generate.h"
#include "golden/scene/noise.h"

namespace ptm::golden {
namespace {

TEST(PointTexel, IsThatOfTheEndlessRowOnEveryEdgeAndBetween) {
  // Exact: sides are powers of two, and samples lie on quarters of a texel.
  for (const int side : {1, 2, 4, 32}) {
    for (int quarter = -12 * side; quarter <= 12 * side; ++quarter) {
      const double coordinate = static_cast<double>(quarter) / (4 * side);
      const int endless = quarter >= 0 ? quarter / 4 : -((-quarter + 3) / 4);
      const int repeated = (endless % side + side) % side;
      const int turn = (endless % (2 * side) + 2 * side) % (2 * side);
      EXPECT_EQ(point_texel(coordinate, side, WrapMode::repeat), repeated) << coordinate;
      EXPECT_EQ(point_texel(coordinate, side, WrapMode::mirror),
                turn < side ? turn : 2 * side - 1 - turn)
          << coordinate << " of " << side;
      EXPECT_EQ(point_texel(coordinate, side, WrapMode::clamp), std::clamp(endless, 0, side - 1));
    }
  }
}

/// A picture whose texel i, j is i + 10 j in red; 7, 8 and 9 elsewhere.
LoadedTexture counted(int width, int height) {
  LoadedTexture texture;
  texture.polynomials = 0;
  texture.width = width;
  texture.height = height;
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      for (const double value : {i + 10.0 * j, 7.0, 8.0, 9.0}) texture.rgba.push_back(value);
    }
  }
  return texture;
}

LoadedTexture generated(const char* pattern, int width, int height, MapKind kind,
                        bool plain = false) {
  TextureSpec spec;
  spec.pattern = pattern;
  spec.size = {width, height};
  spec.kind = kind;
  spec.plain = plain;
  return generate_texture(spec);
}

double red(const MipTexture& mips, const TextureQuery& query) {
  return filter_texture(mips, query)[0];
}

TEST(Wrapped, TakesCoordinatesIntoOnePeriod) {
  EXPECT_DOUBLE_EQ(wrapped(-0.25, WrapMode::repeat), 0.75);
  EXPECT_DOUBLE_EQ(wrapped(3.25, WrapMode::repeat), 0.25);
  EXPECT_DOUBLE_EQ(wrapped(-0.25, WrapMode::mirror), 0.25);
  EXPECT_DOUBLE_EQ(wrapped(1.25, WrapMode::mirror), 0.75);
  EXPECT_DOUBLE_EQ(wrapped(2.25, WrapMode::mirror), 0.25);
  EXPECT_DOUBLE_EQ(wrapped(-1.25, WrapMode::mirror), 0.75);
  EXPECT_DOUBLE_EQ(wrapped(-0.25, WrapMode::clamp), 0);
  EXPECT_DOUBLE_EQ(wrapped(7, WrapMode::clamp), 1);
}

TEST(TextureFilter, PointSamplingTakesTheTexelThatHoldsThePoint) {
  const LoadedTexture texture = counted(5, 3);
  const MipTexture mips(texture, false);
  const FilterMode point{false, MipMode::none};
  EXPECT_EQ(red(mips, {.u = 0.39, .v = 0.34, .filter = point}), 11);
  EXPECT_EQ(red(mips, {.u = 0.41, .v = 0.32, .filter = point}), 2);
  for (const WrapMode wrap : {WrapMode::repeat, WrapMode::mirror, WrapMode::clamp}) {
    // At the edges, exactly and a hair beyond, no texel outside is asked for.
    for (const double u : {-1.0, -0x1p-60, 0.0, 0x1p-60, 1 - 0x1p-53, 1.0, 2.0}) {
      const double value = red(mips, {.u = u, .v = 0, .filter = point, .wrap_u = wrap});
      EXPECT_TRUE(value == 0 || value == 4) << u;
    }
  }
}

TEST(TextureFilter, BilinearMeetsTheNeighbourThatTheWrapNames) {
  const LoadedTexture texture = counted(4, 1);
  const MipTexture mips(texture, false);
  EXPECT_DOUBLE_EQ(red(mips, {.u = 0.5, .v = 0.5}), 1.5);
  EXPECT_DOUBLE_EQ(red(mips, {.u = 0.40625, .v = 0.5}), 1.125);
  EXPECT_DOUBLE_EQ(red(mips, {.u = 0.0625, .v = 0.5}), 0.25 * 3) << "a quarter of the last one";
  EXPECT_DOUBLE_EQ(red(mips, {.u = 0.0625, .v = 0.5, .wrap_u = WrapMode::mirror}), 0);
  EXPECT_DOUBLE_EQ(red(mips, {.u = -0.0625, .v = 0.5, .wrap_u = WrapMode::clamp}), 0);
  EXPECT_DOUBLE_EQ(red(mips, {.u = 1.0, .v = 0.5}), 1.5) << "between the last and the first";
}

TEST(TextureFilter, HugeAndNegativeCoordinatesGiveWhatTheirFractionsGive) {
  const LoadedTexture texture = generated("noise", 24, 40, MapKind::lrgb);
  const MipTexture mips(texture, true);
  for (int n = 0; n < 200; ++n) {
    const double u = std::floor(4096 * hash_noise(1, n, 0)) / 4096;
    const double v = std::floor(4096 * hash_noise(1, n, 1)) / 4096;
    for (const WrapMode wrap : {WrapMode::repeat, WrapMode::mirror}) {
      TextureQuery query{.u = u,
                         .v = v,
                         .lod = 1.5,
                         .filter = {true, MipMode::linear},
                         .wrap_u = wrap,
                         .wrap_v = wrap,
                         .light = {0.3, -0.2}};
      const Rgba here = filter_texture(mips, query);
      query.u += 1e9;
      query.v -= 2e8;
      EXPECT_EQ(filter_texture(mips, query), here);
    }
  }
}

TEST(TextureFilter, OfOneTexelGivesThatTexelAtEveryLevelOfDetail) {
  const LoadedTexture texture = generated("noise", 1, 1, MapKind::rgb);
  const MipTexture mips(texture, true);
  EXPECT_EQ(mips.levels(), 1);
  const Rgba texel = mips.texel(0, 0, 0, {0.1, 0.2});
  for (const double lod : {-20.0, 0.0, 0.7, 12.0}) {
    for (const double u : {-3.7, 0.0, 0.5, 1.0, 99.9}) {
      const Rgba found = filter_texture(mips, {.u = u,
                                               .v = -u,
                                               .axis_u = 0.3,
                                               .probes = 8,
                                               .lod = lod,
                                               .filter = {true, MipMode::linear},
                                               .light = {0.1, 0.2}});
      for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(found[c], texel[c], 1e-12);
    }
  }
}

TEST(TextureFilter, ChoosesLevelsAsTheirFormulaSays) {
  const LoadedTexture texture = counted(8, 8);
  const MipTexture mips(texture, true);
  ASSERT_EQ(mips.levels(), 4);
  const auto level = [&](int l) {
    return red(
        mips,
        {.u = 0.3, .v = 0.6, .lod = static_cast<double>(l), .filter = {true, MipMode::linear}});
  };
  EXPECT_NE(level(0), level(1));
  const auto nearest = [&](double lod) {
    return red(mips, {.u = 0.3, .v = 0.6, .lod = lod, .filter = {true, MipMode::nearest}});
  };
  EXPECT_EQ(nearest(-3), level(0));
  EXPECT_EQ(nearest(0.49), level(0));
  EXPECT_EQ(nearest(0.5), level(1));
  EXPECT_EQ(nearest(9), level(3));
  const auto linear = [&](double lod) {
    return red(mips, {.u = 0.3, .v = 0.6, .lod = lod, .filter = {true, MipMode::linear}});
  };
  EXPECT_DOUBLE_EQ(linear(1.25), 0.75 * level(1) + 0.25 * level(2));
  EXPECT_EQ(linear(-1), level(0));
  EXPECT_EQ(linear(7.5), level(3));
  const auto none = [&](double lod) { return red(mips, {.u = 0.3, .v = 0.6, .lod = lod}); };
  EXPECT_EQ(none(2), level(0));
}

TEST(TextureFilter, AveragesProbesCentredOnThePoint) {
  const LoadedTexture texture = counted(8, 1);
  const MipTexture mips(texture, false);
  const FilterMode point{false, MipMode::none};
  // Probes at 0.5 +- 1/16, +- 3/16 of the width: texels 2, 3, 4, 5.
  EXPECT_DOUBLE_EQ(red(mips, {.u = 0.5, .v = 0.5, .axis_u = 0.125, .probes = 4, .filter = point}),
                   3.5);
  EXPECT_DOUBLE_EQ(red(mips, {.u = 0.5, .v = 0.5, .axis_u = 0.125, .probes = 4}), 3.5);
  EXPECT_DOUBLE_EQ(
      red(mips, {.u = 0.5625, .v = 0.5, .axis_u = 0.125, .probes = 1, .filter = point}), 4);
}

TEST(TextureFilter, LightsBeforeItFilters) {
  // Two texels, one far below black and one white: filtering coefficients first gives black.
  LoadedTexture texture;
  texture.width = 2;
  texture.height = 1;
  texture.coef = {0, 0, 0, 0, 0, -600, 0, 0, 0, 0, 0, 255};
  texture.color = {255, 255, 255, 255, 255, 255};
  const MipTexture mips(texture, false);
  EXPECT_DOUBLE_EQ(red(mips, {.u = 0.5, .v = 0.5}), 127.5);
}

TEST(MipTexture, KeepsTheMeanAtOddSizesOnEveryLevel) {
  for (const bool plain : {true, false}) {
    const LoadedTexture texture = generated("relief", 37, 10, MapKind::lrgb, plain);
    const MipTexture mips(texture, true);
    EXPECT_EQ(mips.levels(), 6);
    EXPECT_EQ(mips.width(2), 9);
    EXPECT_EQ(mips.height(3), 1);
    const std::array<double, 2> light{0, 0};  // no texel is clamped there
    const auto mean = [&](int level) {
      double sum = 0;
      for (int j = 0; j < mips.height(level); ++j) {
        for (int i = 0; i < mips.width(level); ++i) sum += mips.texel(level, i, j, light)[1];
      }
      return sum / (mips.width(level) * mips.height(level));
    };
    for (int level = 1; level < 6; ++level) EXPECT_NEAR(mean(level), mean(0), 1e-9) << level;
  }
}

TEST(MipTexture, AveragesWhatTexelsRadiateNotColoursAndLuminanceApart) {
  LoadedTexture texture;
  texture.width = 2;
  texture.height = 1;
  texture.coef = {0, 0, 0, 0, 0, 200, 0, 0, 0, 0, 0, 0};  // bright beside black
  texture.color = {255, 0, 0, 0, 255, 0};                 // red beside green
  const MipTexture mips(texture, true);
  const Rgba top = mips.texel(1, 0, 0, {0, 0});
  EXPECT_DOUBLE_EQ(top[0], 100);
  EXPECT_DOUBLE_EQ(top[1], 0);
}

TEST(AreaAverage, WeighsTexelsByTheAreaThatIsCovered) {
  const LoadedTexture texture = counted(4, 4);
  const MipTexture mips(texture, false);
  const auto average = [&](const PixelFootprint& footprint, WrapMode wrap = WrapMode::repeat) {
    return area_average(mips, footprint, wrap, wrap, {})[0];
  };
  // A box from (0.5, 1) to (2, 2) texels: half of texel 10 and all of 11.
  EXPECT_NEAR(average({.u = 1.25 / 4, .v = 1.5 / 4, .dudx = 1.5 / 4, .dvdy = 0.25}),
              (0.5 * 10 + 11) / 1.5, 1e-12);
  // A square on its tip, of diagonal 2, about the corner that four texels share.
  EXPECT_NEAR(
      average({.u = 0.5, .v = 0.5, .dudx = 0.25, .dvdx = 0.25, .dudy = 0.25, .dvdy = -0.25}),
      (11 + 12 + 21 + 22) / 4.0, 1e-12);
  EXPECT_NEAR(average({.u = 0.3, .v = 0.8, .dudx = 3, .dvdy = 2}), 16.5, 1e-10) << "all texels";
  EXPECT_NEAR(average({.u = -5, .v = 0.125, .dudx = 2, .dvdy = 0.01}, WrapMode::clamp), 0, 1e-12);
  // From texel -1 to 1 mirrored: the first texel twice.
  EXPECT_NEAR(average({.u = 0, .v = 0.125, .dudx = 0.5, .dvdy = 0.25}, WrapMode::mirror), 0, 1e-12);
  EXPECT_NEAR(average({.u = 0, .v = 0.125, .dudx = 0.5, .dvdy = 0.25}), 1.5, 1e-12);
}

TEST(AreaAverage, OfAnyParallelogramIsWhatManySamplesGive) {
  const LoadedTexture texture = generated("noise", 13, 9, MapKind::lrgb);
  const MipTexture mips(texture, false);
  constexpr int grid = 700;
  for (int n = 0; n < 12; ++n) {
    const auto r = [&](int which) { return hash_noise(9, n, which) - 0.5; };
    const PixelFootprint f{
        .u = 3 * r(0), .v = 3 * r(1), .dudx = r(2), .dvdx = r(3), .dudy = r(4), .dvdy = r(5)};
    const WrapMode wrap = n % 2 == 0 ? WrapMode::mirror : WrapMode::repeat;
    double sum = 0;
    for (int b = 0; b < grid; ++b) {
      for (int a = 0; a < grid; ++a) {
        const double s = (a + 0.5) / grid - 0.5, t = (b + 0.5) / grid - 0.5;
        sum += red(mips, {.u = f.u + s * f.dudx + t * f.dudy,
                          .v = f.v + s * f.dvdx + t * f.dvdy,
                          .filter = {false, MipMode::none},
                          .wrap_u = wrap,
                          .wrap_v = wrap});
      }
    }
    // At most (26 + 18) borders cross 2 * 700 parts each of 490,000, with differences up to 255
    // that fall to either side alike: far below this.
    const double found = area_average(mips, f, wrap, wrap, {})[0];
    EXPECT_NEAR(found, sum / (grid * grid), 0.3) << n;
  }
}

TEST(AreaAverage, SamplesWhatIsTooThinOrTooLargeToClip) {
  const LoadedTexture texture = counted(4, 4);
  const MipTexture mips(texture, false);
  const WrapMode wrap = WrapMode::repeat;
  const auto average = [&](const PixelFootprint& f) {
    return area_average(mips, f, wrap, wrap, {})[0];
  };
  EXPECT_NEAR(average({.u = 0.5, .v = 0.125, .dudx = 1}), 1.5, 1e-12) << "a line over a row";
  EXPECT_EQ(average({.u = 0.3, .v = 0.3}), 11) << "a point";
  // 64 x 64 periods of 4 x 4 texels, 256 x 256 parts: every part holds one texel.
  EXPECT_NEAR(average({.u = 0.5, .v = 0.5, .dudx = 65, .dvdy = 64}), 16.5, 0.5);
}

}  // namespace
}  // namespace ptm::golden
