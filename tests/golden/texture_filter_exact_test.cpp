#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "golden/render/light_map.h"
#include "golden/render/texture_filter.h"
#include "golden/scene/flat_samples.h"
#include "golden/scene/noise.h"
#include "tests/golden/exact_sampling.h"

namespace ptm::golden {
namespace {

constexpr std::array kWraps{WrapMode::repeat, WrapMode::mirror, WrapMode::clamp};
constexpr std::array kMips{MipMode::none, MipMode::nearest, MipMode::linear};
constexpr std::array kSides{1, 2, 3, 4, 5, 6, 7, 10, 12, 49, 64, 93, 250};

double next(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
double before(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

/// Edges and centres of texels over three periods either way, the doubles on both sides of each,
/// and places between.
std::vector<double> coordinates(int side) {
  std::vector<double> all{0.0, -0.0, 0x1p-60, -0x1p-60};
  const int step = side > 64 ? 7 : 1;
  for (int half = -6 * side; half <= 6 * side; half += step) {
    const double u = static_cast<double>(half) / (2 * side);
    for (const double near : {u, next(u), before(u), u + 0.3 / side}) {
      if (std::abs(near) >= 0x1p-18 || near == 0) all.push_back(near);
    }
  }
  return all;
}

std::string shown(WrapMode wrap) {
  return wrap == WrapMode::repeat ? "repeat" : wrap == WrapMode::mirror ? "mirror" : "clamp";
}

TEST(ExactSampling, FindsTheDoubleNearestToAFraction) {
  // The processor's division is correctly rounded: the oracle must agree with it.
  for (const int side : kSides) {
    for (std::int64_t k = -300; k <= 300; ++k) {
      ASSERT_EQ(tests::nearest_double(k, side), static_cast<double>(k) / side) << k << "/" << side;
    }
  }
}

TEST(PointTexel, EqualsTheOneBetweenItsEdgesForEveryWrapSignAndTie) {
  for (const int side : kSides) {
    for (const double u : coordinates(side)) {
      for (const WrapMode wrap : kWraps) {
        const int expected = tests::wrapped_texel(tests::endless_by_edges(u, side), side, wrap);
        ASSERT_EQ(point_texel(u, side, wrap), expected)
            << std::hexfloat << u << " of " << side << ", " << shown(wrap);
      }
    }
  }
}

TEST(PointTexel, TakesTheTexelAboveAnEdgeThatNoDoubleMeets) {
  // 1/49 times 49 is rounded to below 1; the edge's own texel is 1 all the same.
  ASSERT_LT(1.0 / 49 * 49, 1);
  EXPECT_EQ(point_texel(1.0 / 49, 49, WrapMode::repeat), 1);
  EXPECT_EQ(point_texel(-1.0 / 49, 49, WrapMode::repeat), 48);
  EXPECT_EQ(point_texel(-1.0 / 49, 49, WrapMode::mirror), 0);
  EXPECT_EQ(point_texel(2 + 3.0 / 10, 10, WrapMode::repeat), 3);
}

TEST(PointTexel, StaysExactWhereDoublesAreWiderApartThanTexels) {
  for (const double u : {1e17, -1e17, 0x1p60, 1e300, -1e300}) {
    // Even numbers all: the first texel of a period that is not mirrored.
    for (const WrapMode wrap : {WrapMode::repeat, WrapMode::mirror}) {
      EXPECT_EQ(point_texel(u, 7, wrap), 0) << u;
    }
    EXPECT_EQ(point_texel(u, 7, WrapMode::clamp), u < 0 ? 0 : 6);
  }
  EXPECT_EQ(point_texel(0x1p52 + 1, 7, WrapMode::mirror), 6) << "an odd period begins";
}

TEST(FlatSamples, TakeTheUpperTexelOfEveryEdgeAtHalfTheSize) {
  PtmMap map;
  for (int half = 1; half <= 600; ++half) {
    map.width = 2 * half;
    map.height = 1;
    for (int x = 0; x < half; ++x) {
      ASSERT_EQ(nearest_texel(map, flat_sample(x, 0, half, 1, {})),
                static_cast<std::size_t>(2 * x + 1))
          << half;
    }
  }
}

/// A picture of whole levels, so that the exact mixtures are known.
LoadedTexture picture(int width, int height) {
  LoadedTexture texture;
  texture.polynomials = 0;
  texture.width = width;
  texture.height = height;
  for (int n = 0; n < 4 * width * height; ++n) {
    texture.rgba.push_back(std::floor(256 * hash_noise(5, n, 0)));
  }
  return texture;
}

using Exact = std::array<long double, 4>;

Exact exact_within(const MipTexture& mips, const TextureQuery& query, int level) {
  const bool bilinear = query.filter.bilinear;
  const auto x = tests::exact_pair(query.u, mips.width(level), query.wrap_u, bilinear);
  const auto y = tests::exact_pair(query.v, mips.height(level), query.wrap_v, bilinear);
  Exact sum{};
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t i = 0; i < 2; ++i) {
      const long double weight =
          (i == 0 ? 1 - x.share : x.share) * (j == 0 ? 1 - y.share : y.share);
      const Rgba texel = mips.texel(level, x.texel[i], y.texel[j], query.light);
      for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * texel[c];
    }
  }
  return sum;
}

Exact exact_filter(const MipTexture& mips, const TextureQuery& query) {
  const auto levels = tests::exact_levels(query.lod, mips.levels() - 1, query.filter.mip);
  const Exact first = exact_within(mips, query, levels.level[0]);
  const Exact second = exact_within(mips, query, levels.level[1]);
  Exact mixed{};
  for (std::size_t c = 0; c < 4; ++c) {
    mixed[c] = (1 - levels.share) * first[c] + levels.share * second[c];
  }
  return mixed;
}

/// What doubles may lose. With e = 2^-53, a coordinate within its period is off by e and its
/// product with `side` by another e of at most `side`: a position by 2 side e, and a value moves by
/// 255 a texel. Three mixtures, each of two products and a sum and a rounded 1 - w, add 4 e of 255.
double bound(const MipTexture& mips, const FilterMode& filter) {
  const double positions = filter.bilinear ? 2.0 * (mips.width(0) + mips.height(0)) : 0;
  return 255 * (positions + 3 * 4) * 0x1p-53;
}

void expect_exact(const MipTexture& mips, const TextureQuery& query) {
  const Rgba found = filter_texture(mips, query);
  const Exact expected = exact_filter(mips, query);
  const bool choice_only = !query.filter.bilinear && query.filter.mip != MipMode::linear;
  for (std::size_t c = 0; c < 4; ++c) {
    const long double off = std::abs(found[c] - expected[c]);
    ASSERT_LE(off, choice_only ? 0 : bound(mips, query.filter))
        << std::hexfloat << query.u << ", " << query.v << ", lod " << query.lod << ", "
        << shown(query.wrap_u) << " " << shown(query.wrap_v) << ", bilinear "
        << query.filter.bilinear << ", mip " << static_cast<int>(query.filter.mip);
  }
}

TEST(TextureFilter, EqualsExactMixturesForEveryWrapFilterSignAndTie) {
  // On, just below and just above every level and half level.
  std::vector<double> lods;
  for (double half = -1; half <= 8; ++half) {
    for (const double lod : {half / 2, next(half / 2), before(half / 2), half / 2 + 0.2}) {
      if (std::abs(lod) >= 0x1p-10 || lod == 0) lods.push_back(lod);
    }
  }
  for (const auto& [width, height] : {std::array{6, 5}, {8, 8}, {7, 1}, {1, 12}}) {
    const LoadedTexture texture = picture(width, height);
    const MipTexture mips(texture, true);
    const std::vector<double> us = coordinates(width), vs = coordinates(height);
    std::size_t n = 0;
    for (const bool bilinear : {false, true}) {
      for (const MipMode mip : kMips) {
        for (const WrapMode wrap_u : kWraps) {
          for (const WrapMode wrap_v : kWraps) {
            // Each coordinate and each level of detail, in combinations that keep changing.
            for (std::size_t k = 0; k < us.size() + vs.size() + lods.size(); ++k, ++n) {
              expect_exact(mips, {.u = us[k % us.size()],
                                  .v = vs[(7 * n + k) % vs.size()],
                                  .lod = lods[n % lods.size()],
                                  .filter = {bilinear, mip},
                                  .wrap_u = wrap_u,
                                  .wrap_v = wrap_v});
              if (HasFatalFailure()) return;
            }
          }
        }
      }
    }
  }
}

TEST(TextureFilter, TakesTheLevelBelowJustUnderAHalf) {
  const LoadedTexture texture = picture(4, 4);
  const MipTexture mips(texture, true);
  // One half less one digit: the sum with a half would be rounded to 1.
  const TextureQuery query{
      .u = 0.3, .v = 0.3, .lod = 0.5 - 0x1p-54, .filter = {false, MipMode::nearest}};
  EXPECT_EQ(filter_texture(mips, query)[0], mips.texel(0, 1, 1, {})[0]);
}

TEST(TextureFilter, AveragesProbesAtTheirExactPlaces) {
  // Quarters of texels: probes fall on edges and centres, mirrored and repeated ones too.
  const LoadedTexture texture = picture(8, 4);
  const MipTexture mips(texture, true);
  for (const WrapMode wrap : kWraps) {
    for (const bool bilinear : {false, true}) {
      for (int place = -64; place <= 64; ++place) {
        TextureQuery query{.u = place / 32.0,
                           .v = -place / 16.0,
                           .axis_u = 1 / 8.0,
                           .axis_v = -1 / 4.0,
                           .probes = 4,
                           .filter = {bilinear, MipMode::none},
                           .wrap_u = wrap,
                           .wrap_v = wrap};
        Exact mean{};
        for (const double along : {-1.5, -0.5, 0.5, 1.5}) {
          TextureQuery probe = query;
          probe.probes = 1;
          probe.u += along * query.axis_u;
          probe.v += along * query.axis_v;
          const Exact value = exact_filter(mips, probe);
          for (std::size_t c = 0; c < 4; ++c) mean[c] += value[c] / 4;
        }
        // All of it fits a double's digits: eighths of texels, whole levels, quarters of sums.
        const Rgba found = filter_texture(mips, query);
        for (std::size_t c = 0; c < 4; ++c) ASSERT_EQ(found[c], mean[c]) << place << shown(wrap);
      }
    }
  }
}

}  // namespace
}  // namespace ptm::golden
