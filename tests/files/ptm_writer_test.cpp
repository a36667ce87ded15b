#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <stdexcept>
#include <tuple>

#include "golden/files/plane_codec.h"
#include "golden/files/prediction.h"
#include "golden/files/ptm_header.h"
#include "tests/files/crafted_ptm.h"
#include "tests/scratch_folder.h"

namespace ptm::tests {
namespace {

using golden::Coding;
using golden::MapKind;
using golden::PtmMap;
using golden::PtmWriteOptions;

struct WrittenFormat {
  const char* name;
  MapKind kind;
  PtmWriteOptions options;
};

std::vector<WrittenFormat> all_formats() {
  return {{"Lrgb", MapKind::lrgb, {}},
          {"Lrgb11", MapKind::lrgb, {.version_1_1 = true}},
          {"Rgb", MapKind::rgb, {}},
          {"Lum", MapKind::lum, {}},
          {"JpegLrgb", MapKind::lrgb, {.coding = Coding::jpeg}},
          {"JpegLrgbInverted", MapKind::lrgb, {.coding = Coding::jpeg, .inversion = true}},
          {"JpegLrgbPoor", MapKind::lrgb, {.coding = Coding::jpeg, .jpeg_quality = 5}},
          {"JpegRgb", MapKind::rgb, {.coding = Coding::jpeg}},
          {"JpegLsLrgb", MapKind::lrgb, {.coding = Coding::jpegls}},
          {"JpegLsRgb", MapKind::rgb, {.coding = Coding::jpegls}}};
}

PtmMap round_trip(const PtmMap& map, const PtmWriteOptions& options) {
  return golden::parse_ptm(golden::format_ptm(map, options), "written").map;
}

std::string header_text(const PtmMap& map, const PtmWriteOptions& options) {
  const Bytes bytes = golden::format_ptm(map, options);
  const auto size = golden::parse_ptm_header(bytes, "written").info.header_bytes;
  return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)};
}

class RoundTrip : public testing::TestWithParam<WrittenFormat> {};

TEST_P(RoundTrip, MapsOfAllSizesReadBackIdentically) {
  constexpr std::array<std::array<int, 2>, 7> sizes{
      {{1, 1}, {3, 5}, {17, 4}, {1, 40}, {40, 1}, {64, 33}, {8, 8}}};
  for (const auto& [width, height] : sizes) {
    for (const bool smooth : {false, true}) {
      const PtmMap map = made_map(GetParam().kind, width, height, 7, smooth);
      EXPECT_TRUE(round_trip(map, GetParam().options) == map)
          << width << " x " << height << (smooth ? " smooth" : " noise");
    }
  }
}

TEST_P(RoundTrip, HeaderSuitsTheStrictestReader) {
  const std::string text = header_text(made_map(GetParam().kind, 3, 5, 1), GetParam().options);
  EXPECT_EQ(text.find(" \n"), std::string::npos) << "a blank before a line's end";
  EXPECT_EQ(text.find("  "), std::string::npos) << "two blanks";
  EXPECT_EQ(text.find('\r'), std::string::npos);
  EXPECT_NE(text.find("\n3\n5\n"), std::string::npos) << "width and height on lines of their own";
  EXPECT_NE(text.find("\n527 -715 0 255 -2147483648 2147483647\n"), std::string::npos);
  EXPECT_NE(text.find("\n2.0 0.5 -0.1 1e-30 0.3333333333333333 1.23456789015e+10\n"),
            std::string::npos);
}

TEST_P(RoundTrip, TheSameMapGivesTheSameBytes) {
  const PtmMap map = made_map(GetParam().kind, 31, 9, 3, true);
  EXPECT_EQ(golden::format_ptm(map, GetParam().options),
            golden::format_ptm(map, GetParam().options));
}

INSTANTIATE_TEST_SUITE_P(, RoundTrip, testing::ValuesIn(all_formats()),
                         [](const auto& row) { return row.param.name; });

TEST(PtmWriter, WritesLrgbByteByByte) {
  PtmMap map;
  map.width = 1;
  map.height = 2;
  map.scale = {1, 2, 3, 4, 5, 6};
  map.bias = {0, 10, 20, 30, 40, 50};
  map.coef = {10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5};
  map.color = {23, 24, 25, 20, 21, 22};
  const Bytes expected =
      to_bytes("PTM_1.2\nPTM_FORMAT_LRGB\n1\n2\n1.0 2.0 3.0 4.0 5.0 6.0\n0 10 20 30 40 50\n") +
      Bytes{0, 1, 2, 3, 4, 5, 10, 11, 12, 13, 14, 15, 20, 21, 22, 23, 24, 25};
  EXPECT_EQ(golden::format_ptm(map), expected);
}

TEST(PtmWriter, JpegHasItsEightLinesAndNoInversionUnlessAsked) {
  const PtmMap map = made_map(MapKind::lrgb, 8, 8, 1, true);
  const PtmWriteOptions options{.coding = Coding::jpeg, .jpeg_quality = 90};
  const std::string text = header_text(map, options);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 14);
  const std::string zeros = "0 0 0 0 0 0 0 0 0\n";
  EXPECT_NE(text.find("\n90\n" + zeros + zeros + zeros), std::string::npos) << text;
}

/// A plane of which another is the opposite.
PtmMap map_with_opposite_planes() {
  PtmMap map = made_map(MapKind::lrgb, 64, 64, 5);
  for (std::size_t i = 0; i < map.texels(); ++i) {
    map.coef[6 * i + 1] = static_cast<std::uint8_t>(255 - map.coef[6 * i]);
  }
  return map;
}

TEST(PtmWriter, InvertsPlanesWhenAskedAndSaysThatRelightRefusesThem) {
  ScratchFolder folder;
  const PtmMap map = map_with_opposite_planes();
  const PtmWriteOptions options{.coding = Coding::jpeg, .inversion = true};
  const auto notes = golden::write_ptm(folder / "a.ptm", map, options);
  const golden::PtmFile file = golden::read_ptm(folder / "a.ptm");
  EXPECT_EQ(file.info.transforms[0] + file.info.transforms[1], 1);
  EXPECT_TRUE(file.map == map);
  EXPECT_NE(
      std::find(notes.begin(), notes.end(), "relight refuses JPEG files with inverted planes"),
      notes.end());
}

TEST(PtmWriter, LossyJpegIsSmallAndClose) {
  const PtmMap map = made_map(MapKind::lrgb, 64, 64, 1, true);
  const PtmWriteOptions options{.coding = Coding::jpeg, .exact = false};
  const PtmMap read = round_trip(map, options);
  EXPECT_LT(golden::format_ptm(map, options).size(), golden::format_ptm(map).size() / 2);
  for (std::size_t i = 0; i < map.coef.size(); ++i) {
    ASSERT_NEAR(map.coef[i], read.coef[i], 12) << i;  // quality 95 divides the DCT by 12 at most
  }
}

/// RTIViewer keeps sums above 255 as they are and HP's viewer treats a coded 0 apart: neither may
/// meet one that side information does not overwrite.
TEST(PtmWriter, JpegNeedsNoReaderThatWraps) {
  for (const bool exact : {true, false}) {
    PtmMap map = made_map(MapKind::lrgb, 64, 64, 1, true);
    std::mt19937 random(9);
    for (std::size_t i = 0; i < map.texels(); ++i) {  // like planes near both ends of the range
      const auto base = static_cast<std::uint8_t>(random() & 255U);
      map.coef[6 * i] = base;
      map.coef[6 * i + 1] = static_cast<std::uint8_t>(base < 4 ? base : base - random() % 4);
      map.coef[6 * i + 2] = i % 50 == 0 ? 255 : base;
    }
    const Bytes bytes =
        golden::format_ptm(map, {.coding = Coding::jpeg, .exact = exact, .inversion = true});
    const auto info = golden::parse_ptm_header(bytes, "written").info;
    const golden::PtmMap read = golden::parse_ptm(bytes, "written").map;
    std::size_t at = info.header_bytes, predicted_planes = 0, astray = 0;
    for (std::size_t p = 0; p < 6; ++p) {
      const auto stream = std::span(bytes).subspan(at, info.compressed_bytes[p]);
      const auto side = std::span(bytes).subspan(at + stream.size(), info.side_bytes[p]);
      at += stream.size() + side.size();
      const std::string name = "written";
      const golden::Plane coded = golden::decode_jpeg_plane({stream, name, "plane"}, 64, 64);
      if (info.references[p] < 0) continue;
      ++predicted_planes;
      std::vector<bool> overwritten(map.texels());
      for (std::size_t r = 0; r < side.size(); r += 5) {
        overwritten[std::size_t{side[r + 2]} << 8 | side[r + 3]] = true;
      }
      for (std::size_t i = 0; i < map.texels(); ++i) {
        const std::size_t texel = (63 - i / 64) * 64 + i % 64;
        const std::uint8_t reference =
            read.coef[6 * texel + static_cast<std::size_t>(info.references[p])];
        const int sum =
            coded.bytes()[i] + golden::predictor(reference, info.transforms[p] == 1) - 128;
        if (sum < 0 || sum > 255 || coded.bytes()[i] == 0) {
          ++astray;
          ASSERT_TRUE(overwritten[i]) << "plane " << p << ", texel " << i;
        }
      }
    }
    EXPECT_GT(predicted_planes, 0U);
    EXPECT_GT(astray, 0U) << "the map does not try what this test is about";
  }
}

TEST(PtmWriter, NotesWhatOtherReadersGetWrong) {
  ScratchFolder folder;
  PtmMap map = made_map(MapKind::lrgb, 6, 4, 1, true);
  const auto notes_of = [&](const PtmWriteOptions& options) {
    std::string all;
    for (const auto& note : golden::write_ptm(folder / "a.ptm", map, options)) all += note + "\n";
    return all;
  };
  const std::size_t first = 6 * 6 * 3;  // the file's first texel, bottom left
  map.coef[first] = 'x';
  EXPECT_EQ(notes_of({}), "");
  map.coef[first] = '\n';
  EXPECT_NE(notes_of({}).find("white-space"), std::string::npos);
  EXPECT_NE(notes_of({.coding = Coding::jpeg}).find("multiple of 4"), std::string::npos);
  EXPECT_NE(notes_of({.coding = Coding::jpegls}).find("JPEGLS_LRGB"), std::string::npos);
  map = made_map(MapKind::lrgb, 64, 64, 1);
  EXPECT_NE(notes_of({.coding = Coding::jpeg}).find("larger than uncompressed"), std::string::npos);
}

TEST(PtmWriter, RefusesMapsThatAreNone) {
  ScratchFolder folder;
  const auto refuses = [&](auto damage, const PtmWriteOptions& options = {},
                           MapKind kind = MapKind::lrgb) {
    PtmMap map = made_map(kind, 4, 4, 1);
    damage(map);
    EXPECT_THROW(golden::write_ptm(folder / "a.ptm", map, options), std::invalid_argument);
  };
  const auto nothing = [](PtmMap&) {};
  refuses([](PtmMap& map) { map.width = 5; });
  refuses([](PtmMap& map) { map.color.pop_back(); });
  refuses([](PtmMap& map) { map = {}; });
  refuses([](PtmMap& map) { map.scale[2] = 0; });
  refuses([](PtmMap& map) { map.scale[2] = std::numeric_limits<double>::quiet_NaN(); });
  refuses([](PtmMap& map) { map.lum_matrix[3] = HUGE_VAL; }, {}, MapKind::lum);
  refuses(nothing, {.coding = Coding::jpeg}, MapKind::lum);
  refuses(nothing, {.coding = Coding::jpeg, .version_1_1 = true});
  refuses(nothing, {.version_1_1 = true}, MapKind::rgb);
  refuses(nothing, {.coding = Coding::jpeg, .jpeg_quality = 0});
  EXPECT_EQ(folder.files(), 0U);
}

TEST(PtmWriter, ReplacesTheTargetWholeOrNotAtAll) {
  ScratchFolder folder;
  const PtmMap map = made_map(MapKind::lrgb, 4, 4, 1);
  golden::write_ptm(folder / "a.ptm", map);
  golden::write_ptm(folder / "a.ptm", map, {.coding = Coding::jpegls});
  EXPECT_EQ(golden::read_ptm(folder / "a.ptm").info.format, "PTM_FORMAT_JPEGLS_LRGB");
  EXPECT_EQ(folder.files(), 1U);
  EXPECT_THROW(golden::write_ptm(folder / "none" / "a.ptm", map), golden::InputError);
  std::filesystem::create_directory(folder / "b.ptm");
  EXPECT_THROW(golden::write_ptm(folder / "b.ptm", map), golden::InputError);
  EXPECT_EQ(folder.files(), 2U);
}

}  // namespace
}  // namespace ptm::tests
