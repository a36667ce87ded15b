#include "golden/fit/hp_quantizer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "golden/files/ptm_file.h"
#include "golden/files/ptm_row_writer.h"
#include "golden/files/whole_file.h"
#include "tests/scratch_folder.h"

namespace ptm::golden {
namespace {

HpGrid grid_of(double low, double high) {
  CoefficientRange range;
  range.low.fill(low);
  range.high.fill(high);
  return hp_grid(range);
}

TEST(HpQuantizer, ChoosesScaleAndBiasByTheRangesExponent) {
  const struct {
    double low, high, scale;
    int bias;
  } cases[] = {
      {0, 255, 1, 0},         // 255 = .996 * 2^8
      {0, 256, 2, 0},         // 256 = .5 * 2^9
      {-100, 100, 1, 101},    // 200 = .78 * 2^8; int(100 + 1)
      {-83.2, 10, 0.5, 167},  // int(166.4 + 1)
      {-1000, -990, 4, 251},  // range 10, scale 1/16, doubled until the bias fits
      {1000, 1010, 4, 0},     // scale doubled until the largest fits
      {5, 5, 1 / 32.0, 0},    // no range: 2^-8, doubled until 5 / scale <= 255
      {0, 0, 1 / 256.0, 0},   // all zero: no scale is 0 or infinite
  };
  for (const auto& c : cases) {
    const HpGrid grid = grid_of(c.low, c.high);
    EXPECT_EQ(grid.scale[3], c.scale) << c.low << " to " << c.high;
    EXPECT_EQ(grid.bias[3], c.bias) << c.low << " to " << c.high;
  }
  EXPECT_THROW((void)hp_grid(CoefficientRange{}), std::invalid_argument);
}

TEST(HpQuantizer, RoundsHalvesUpAndCountsWhatDoesNotFit) {
  const HpGrid grid = grid_of(-100, 155);  // scale 1, bias 101
  const std::vector<double> coef{-100, 0.5, 0.49, 154, 154.5, -102};
  std::vector<std::uint8_t> bytes(6);
  std::array<std::uint64_t, 6> saturated{};
  hp_store(coef, grid, bytes, saturated);
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{1, 102, 101, 255, 255, 0}));
  EXPECT_EQ(saturated, (std::array<std::uint64_t, 6>{0, 0, 0, 0, 1, 1}));
}

TEST(PtmRowWriter, WritesTheBytesOfWritePtmInAnyOrderOfRows) {
  const tests::ScratchFolder folder;
  for (const MapKind kind : {MapKind::lrgb, MapKind::rgb, MapKind::lum}) {
    PtmMap map;
    map.kind = kind;
    map.width = 3;
    map.height = 7;
    map.scale = {0.5, 1, 2, 4, 8, 16};
    map.bias = {1, 2, 3, 4, 5, 6};
    map.coef.resize(21 * 6 * map.polynomials());
    map.color.resize(21 * map.color_bytes());
    for (std::size_t n = 0; n < map.coef.size(); ++n) map.coef[n] = static_cast<std::uint8_t>(n);
    for (std::size_t n = 0; n < map.color.size(); ++n)
      map.color[n] = static_cast<std::uint8_t>(n * 3);
    PtmMap shape = map;
    shape.coef.clear();
    shape.color.clear();
    PtmRowWriter writer(folder / "rows.ptm", shape);
    const std::size_t coef_row = map.coef.size() / 7, color_row = map.color.size() / 7;
    for (const auto& [first, rows] : {std::pair{4, 3}, {0, 1}, {1, 3}}) {
      const auto from = static_cast<std::size_t>(first), count = static_cast<std::size_t>(rows);
      writer.write(first, rows, std::span(map.coef).subspan(from * coef_row, count * coef_row),
                   std::span(map.color).subspan(from * color_row, count * color_row));
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "rows.ptm"));
    writer.commit();
    EXPECT_EQ(read_ptm(folder / "rows.ptm").map, map);
    const auto bytes = format_ptm(map);
    EXPECT_EQ(read_whole_file(folder / "rows.ptm", "PTM_", "a map"), bytes);
    std::filesystem::remove(folder / "rows.ptm");
  }
}

TEST(PtmRowWriter, RefusesRowsThatAreNotTheMapsAndLeavesNothingBehind) {
  const tests::ScratchFolder folder;
  PtmMap shape;
  shape.width = 2;
  shape.height = 2;
  {
    PtmRowWriter writer(folder / "m.ptm", shape);
    const std::vector<std::uint8_t> coef(12), color(6);
    EXPECT_THROW(writer.write(2, 1, coef, color), std::invalid_argument);
    EXPECT_THROW(writer.write(0, 2, coef, color), std::invalid_argument);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
}

}  // namespace
}  // namespace ptm::golden
