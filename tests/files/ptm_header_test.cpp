#include "golden/files/ptm_header.h"

#include <gtest/gtest.h>

#include "tests/files/crafted_ptm.h"

namespace ptm::tests {
namespace {

using golden::InputError;
using golden::parse_ptm;
using golden::PtmFile;

/// A 1 x 2 LRGB file with other text for its lines.
Bytes file_of(const std::string& header) { return to_bytes(header) + counting(18); }

PtmFile read(const Bytes& bytes) { return parse_ptm(bytes, "crafted.ptm"); }

const PtmFile& plain() {
  static const PtmFile file = read(file_of(header_of("LRGB", 1, 2)));
  return file;
}

Bytes with_scales(const std::string& line) {
  return file_of("PTM_1.2\nPTM_FORMAT_LRGB\n1\n2\n" + line + "\n0 0 0 0 0 0\n");
}

Bytes with_biases(const std::string& line) {
  return file_of("PTM_1.2\nPTM_FORMAT_LRGB\n1\n2\n1 1 1 1 1 1\n" + line + "\n");
}

Bytes with_size(const std::string& lines) {
  return file_of("PTM_1.2\nPTM_FORMAT_LRGB\n" + lines + "\n" + scales_and_biases);
}

TEST(PtmHeader, HoldsVersionFormatSizeScalesAndBiases) {
  const PtmFile& file = plain();
  EXPECT_EQ(file.info.version, "PTM_1.2");
  EXPECT_EQ(file.info.format, "PTM_FORMAT_LRGB");
  EXPECT_EQ(file.map.width, 1);
  EXPECT_EQ(file.map.height, 2);
  EXPECT_EQ(file.map.scale, (std::array<double, 6>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(file.map.bias, (std::array<std::int32_t, 6>{0, 10, 20, 30, 40, 50}));
  EXPECT_EQ(file.info.file_bytes, file.info.header_bytes + 18);
  EXPECT_TRUE(file.info.notes.empty());
}

TEST(PtmHeader, WidthAndHeightMayShareALine) { EXPECT_EQ(read(with_size("1 2")).map, plain().map); }

TEST(PtmHeader, ScalesAndBiasesMayShareALine) {
  const PtmFile file =
      read(file_of("PTM_1.2\nPTM_FORMAT_LRGB\n1\n2\n1 2 3 4 5 6 0 10 20 30 40 50\n"));
  EXPECT_EQ(file.map, plain().map);
}

TEST(PtmHeader, BlanksAroundWordsDoNotMatter) {
  const PtmFile file =
      read(file_of("PTM_1.2 \nPTM_FORMAT_LRGB \n 1 \n2\t\n1 2  3 4 5 6 \n0 10 20 30 40\t50 \n"));
  EXPECT_EQ(file.map, plain().map);
}

TEST(PtmHeader, LinesMayEndWithCrLf) {
  const PtmFile file =
      read(file_of("PTM_1.2\r\nPTM_FORMAT_LRGB\r\n1\r\n2\r\n1 2 3 4 5 6 \r\n0 10 20 30 40 50\r\n"));
  EXPECT_EQ(file.map, plain().map);
  EXPECT_EQ(file.info.notes, std::vector<std::string>{"header lines end with CR LF"});
}

TEST(PtmHeader, PayloadMayBeginWithAWhiteSpaceByte) {
  for (const std::uint8_t first : Bytes{0x20, 0x0a, 0x0d, 0x09, 0x0b, 0x0c}) {
    Bytes bytes = file_of(header_of("LRGB", 1, 2));
    bytes[bytes.size() - 18] = first;
    const PtmFile file = read(bytes);
    EXPECT_EQ(file.map.coef[6], first);  // the file's first texel is the bottom row's
    EXPECT_EQ(file.map.coef[7], 1);
  }
}

TEST(PtmHeader, TakesAnyBiasOf32Bits) {
  const PtmFile file = read(with_biases("527 -715 +3 0 2147483647 -2147483648"));
  EXPECT_EQ(file.map.bias, (std::array<std::int32_t, 6>{527, -715, 3, 0, INT32_MAX, INT32_MIN}));
  for (const char* bad : {"2147483648", "-2147483649", "1.5", "0x1", "nan", "1e2"}) {
    const InputError error = refusal_of(with_biases(std::string("0 0 0 0 0 ") + bad));
    EXPECT_EQ(error.place(), "line 6 (biases)") << bad;
    EXPECT_EQ(error.found(), std::string("\"") + bad + "\"");
  }
}

TEST(PtmHeader, TakesAnyFiniteScaleOtherThanZero) {
  const PtmFile file = read(with_scales("-2 1e-300 .5 +3 1e300 5e-324"));
  EXPECT_EQ(file.map.scale, (std::array<double, 6>{-2, 1e-300, 0.5, 3, 1e300, 5e-324}));
  for (const char* bad : {"0", "-0", "0.000", "nan", "-nan", "inf", "-inf", "infinity", "1e999",
                          "1e-999", "2,0", "two"}) {
    const InputError error = refusal_of(with_scales(std::string("1 1 1 1 1 ") + bad));
    EXPECT_EQ(error.place(), "line 5 (scales)") << bad;
    EXPECT_EQ(error.found(), std::string("\"") + bad + "\"");
  }
}

TEST(PtmHeader, RefusesAnotherCountOfScalesOrBiases) {
  EXPECT_EQ(refusal_of(with_scales("1 1 1 1 1")).found(), "5 words");
  EXPECT_EQ(refusal_of(with_scales("1 1 1 1 1 1 1")).found(), "7 words");
  EXPECT_EQ(refusal_of(with_biases("1 1 1 1 1")).place(), "line 6 (biases)");
  EXPECT_EQ(refusal_of(with_biases("1 1 1 1 1 1 1")).place(), "line 6 (biases)");
}

TEST(PtmHeader, RefusesUnknownVersionsNamingTheKnown) {
  for (const char* version : {"PTM_1.0", "PTM_1.3", "PTM_1.25", "PTM_", "#HSH1.2"}) {
    const InputError error = refusal_of(file_of(header_of("LRGB", 1, 2, version)));
    EXPECT_EQ(error.place(), "line 1 (version)") << version;
    EXPECT_EQ(error.expected(), "PTM_1.2 or PTM_1.1");
  }
}

TEST(PtmHeader, RefusesUnknownFormatsNamingTheKnown) {
  for (const char* format : {"PTM_LUT", "PTM_C_LUT", "JPEG_LUM", "HSH", "LRG", "LRGBA", ""}) {
    const InputError error = refusal_of(file_of(header_of(format, 1, 2)));
    EXPECT_EQ(error.place(), "line 2 (format)") << format;
    EXPECT_NE(error.expected().find("LRGB, RGB, LUM, JPEG_LRGB"), std::string::npos);
  }
}

TEST(PtmHeader, RefusesRawFormatsOfVersion11ThatNobodyDescribes) {
  EXPECT_EQ(refusal_of(file_of(header_of("RGB", 1, 1, "PTM_1.1"))).place(), "line 2 (format)");
  EXPECT_EQ(refusal_of(file_of(header_of("LUM", 1, 2, "PTM_1.1"))).place(), "line 2 (format)");
}

TEST(PtmHeader, RefusesEmptyNegativeAndUnreadableSizes) {
  for (const char* bad : {"0\n2", "1\n0", "-1\n-2", "1.0\n2", "1\n2 3", "1 2 3", "x\n2", "\n1\n2",
                          "2147483648\n1", "1\n99999999999999999999"}) {
    const std::string place = refusal_of(with_size(bad)).place();
    EXPECT_TRUE(place.find("width") != std::string::npos ||
                place.find("height") != std::string::npos)
        << bad << ": " << place;
  }
}

TEST(PtmHeader, RefusesSizesThatTheFileCannotHoldWithoutTakingMemory) {
  // 2^62 texels: an allocation would throw bad_alloc, a product in 64 bits would wrap to 0.
  const InputError error = refusal_of(with_size("2147483647\n2147483647"));
  EXPECT_EQ(error.expected(), "2147483647 x 2147483647 x 9 bytes");
}

TEST(PtmHeader, RefusesALineWithoutAnEnd) {
  const InputError error = refusal_of(to_bytes("PTM_1.2" + std::string(5000, ' ')));
  EXPECT_EQ(error.found(), "no line end within 4096 bytes");
}

TEST(PtmHeader, ErrorsNameFilePlaceFoundAndExpected) {
  EXPECT_STREQ(refusal_of(with_size("7x\n2")).what(),
               "crafted.ptm: line 3 (width): found \"7x\", expected a whole number of at least 1");
}

constexpr const char* matrix_line = "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 -16.5\n";

TEST(PtmHeaderLum, ColourMatrixFollowsTheBiases) {
  const PtmFile file = read(to_bytes(header_of("LUM", 1, 2) + matrix_line) + counting(16));
  for (std::size_t i = 0; i < 15; ++i)
    EXPECT_EQ(file.map.lum_matrix[i], static_cast<double>(i + 1));
  EXPECT_EQ(file.map.lum_matrix[15], -16.5);
}

TEST(PtmHeaderLum, MissingMatrixIsJfifsAndSaidSo) {
  const PtmFile file = read(to_bytes(header_of("LUM", 1, 2)) + counting(16));
  EXPECT_EQ(file.map.lum_matrix, golden::jfif_lum_matrix());
  EXPECT_EQ(file.info.notes.size(), 1U);
  EXPECT_EQ(file.map.coef[6], 0);
}

TEST(PtmHeaderLum, FileCutByTheMatrixLineIsNotTakenForOneWithoutMatrix) {
  // What is left after the biases is exactly a payload's size, and still a matrix line.
  const Bytes whole = to_bytes(header_of("LUM", 10, 2) + matrix_line) + counting(160);
  const Bytes cut(whole.begin(), whole.end() - static_cast<int>(std::string(matrix_line).size()));
  EXPECT_EQ(refusal_of(cut).expected(), "10 x 2 x 8 bytes");
}

TEST(PtmHeaderLum, RefusesABrokenMatrix) {
  const Bytes bytes =
      to_bytes(header_of("LUM", 1, 2) + "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 nan\n") + counting(16);
  EXPECT_EQ(refusal_of(bytes).place(), "line 7 (colour matrix)");
}

TEST(PtmHeaderLum, JfifMatrixTurnsGreyToGreyAndPureCrToRed) {
  constexpr auto m = golden::jfif_lum_matrix();
  const auto row = [&](std::size_t r, double cr, double y, double cb) {
    return m[4 * r] * cr + m[4 * r + 1] * y + m[4 * r + 2] * cb + m[4 * r + 3];
  };
  for (std::size_t r = 0; r < 3; ++r) EXPECT_NEAR(row(r, 128, 77, 128), 77, 1e-9);
  EXPECT_NEAR(row(0, 138, 77, 128), 77 + 14.02, 1e-9);
  EXPECT_NEAR(row(1, 138, 77, 128), 77 - 7.14136, 1e-9);
  EXPECT_NEAR(row(2, 128, 77, 118), 77 - 17.72, 1e-9);
  EXPECT_EQ(row(3, 9, 9, 9), 1);
}

}  // namespace
}  // namespace ptm::tests
