#include <gtest/gtest.h>

#include "golden/files/ptm_header.h"
#include "tests/files/crafted_ptm.h"

// Files cut and spoilt: an InputError or a map, never a crash. The asan preset makes that strict.
namespace ptm::tests {
namespace {

using golden::Coding;
using golden::MapKind;

struct Victim {
  const char* name;
  MapKind kind;
  golden::PtmWriteOptions options;
};

class PtmMutation : public testing::TestWithParam<Victim> {
 protected:
  static Bytes file(int width, int height) {
    // Exact JPEG of noise has side information to spoil as well.
    return golden::format_ptm(made_map(GetParam().kind, width, height, 11), GetParam().options);
  }
};

TEST_P(PtmMutation, EveryTruncationIsRefused) {
  const Bytes whole = file(13, 5);
  const std::size_t header = golden::parse_ptm_header(whole, "whole").info.header_bytes;
  for (std::size_t size = 0; size < whole.size(); size += size < header + 300 ? 1 : 13) {
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    try {
      (void)golden::parse_ptm(cut, "cut.ptm");
      ADD_FAILURE() << size << " of " << whole.size() << " bytes were accepted";
    } catch (const golden::InputError& error) {
      EXPECT_EQ(error.file(), "cut.ptm");
      EXPECT_FALSE(error.place().empty() || error.found().empty() || error.expected().empty());
    }
  }
}

TEST_P(PtmMutation, TrailingBytesAreRefused) {
  Bytes bytes = file(13, 5);
  bytes.push_back('\n');
  EXPECT_THROW((void)golden::parse_ptm(bytes, "long.ptm"), golden::InputError);
}

TEST_P(PtmMutation, SpoiltBytesGiveAMapOrAnInputError) {
  const Bytes whole = file(13, 5);
  const std::size_t header = golden::parse_ptm_header(whole, "whole").info.header_bytes;
  std::mt19937 random(2001);
  std::size_t refused = 0, read = 0;
  for (int round = 0; round < 3000; ++round) {
    Bytes bytes = whole;
    // Half of the rounds spoil the header alone, which is the smaller part.
    const std::size_t reach = round % 2 == 0 ? header : bytes.size();
    for (unsigned hits = 1 + random() % 4; hits > 0; --hits) {
      bytes[random() % reach] = static_cast<std::uint8_t>(random() & 255U);
    }
    try {
      const golden::PtmMap map = golden::parse_ptm(bytes, "spoilt.ptm").map;
      ASSERT_EQ(map.coef.size(), map.texels() * 6 * map.polynomials());
      ASSERT_EQ(map.color.size(), map.texels() * map.color_bytes());
      ++read;
    } catch (const golden::InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 500U);
  EXPECT_GT(read, 10U);
}

INSTANTIATE_TEST_SUITE_P(
    , PtmMutation,
    testing::Values(Victim{"Lrgb", MapKind::lrgb, {}},
                    Victim{"Lrgb11", MapKind::lrgb, {.version_1_1 = true}},
                    Victim{"Rgb", MapKind::rgb, {}}, Victim{"Lum", MapKind::lum, {}},
                    Victim{"JpegLrgb", MapKind::lrgb, {.coding = Coding::jpeg}},
                    Victim{"JpegRgb", MapKind::rgb, {.coding = Coding::jpeg}},
                    Victim{"JpegLsLrgb", MapKind::lrgb, {.coding = Coding::jpegls}},
                    Victim{"JpegLsRgb", MapKind::rgb, {.coding = Coding::jpegls}}),
    [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace ptm::tests
