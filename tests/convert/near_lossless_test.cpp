#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "golden/files/plane_codec.h"
#include "golden/files/ptm_file.h"
#include "tests/convert/made_maps.h"

namespace ptm::golden {
namespace {

using tests::smooth_map;

int farthest(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

TEST(NearLossless, KeepsEveryByteWithinTheToleratedLossAndSpendsFewerBits) {
  for (const MapKind kind : {MapKind::lrgb, MapKind::rgb}) {
    const PtmMap map = smooth_map(kind, 61, 47);
    std::size_t before = SIZE_MAX;
    for (const int near : {0, 1, 2, 4, 9}) {
      const auto bytes = format_ptm(map, {.coding = Coding::jpegls, .near = near});
      const PtmMap read = parse_ptm(bytes, "near").map;
      EXPECT_LE(farthest(map.coef, read.coef), near);
      EXPECT_LE(farthest(map.color, read.color), near);
      if (near == 0) {
        EXPECT_EQ(read, map);
      } else {
        EXPECT_EQ(farthest(map.coef, read.coef), near);  // the loss is used
      }
      EXPECT_LT(bytes.size(), before) << near;
      before = bytes.size();
    }
  }
}

TEST(NearLossless, HoldsBytesAtBothEndsWhereDifferencesOfPlanesLeaveTheirRange) {
  // Planes that are each other's opposite, 0 and 255 side by side: no sum may wrap.
  PtmMap map = smooth_map(MapKind::lrgb, 40, 30);
  for (std::size_t i = 0; i < map.coef.size(); ++i) {
    const std::size_t texel = i / 6;
    const bool high = (texel * 2654435761U >> 7 & 1) != 0;
    map.coef[i] = high == (i % 2 == 0) ? 255 : 0;
  }
  for (const int near : {1, 4, 60}) {
    const auto bytes = format_ptm(map, {.coding = Coding::jpegls, .near = near});
    const PtmMap read = parse_ptm(bytes, "near").map;
    EXPECT_LE(farthest(map.coef, read.coef), near);
    EXPECT_LE(farthest(map.color, read.color), near);
  }
}

TEST(NearLossless, IsRefusedForOtherCodingsAndBeyondItsRange) {
  const PtmMap map = smooth_map(MapKind::lrgb, 4, 4);
  EXPECT_THROW((void)format_ptm(map, {.coding = Coding::raw, .near = 1}), std::invalid_argument);
  EXPECT_THROW((void)format_ptm(map, {.coding = Coding::jpeg, .near = 1}), std::invalid_argument);
  for (const int near : {-1, 128}) {
    EXPECT_THROW((void)format_ptm(map, {.coding = Coding::jpegls, .near = near}),
                 std::invalid_argument);
  }
}

}  // namespace
}  // namespace ptm::golden
