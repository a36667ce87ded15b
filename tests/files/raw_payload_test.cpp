#include <gtest/gtest.h>

#include "tests/files/crafted_ptm.h"

// Payloads of 2 x 2 texels whose bytes count 0, 1, 2, ...: each expectation is a place in the file.
namespace ptm::tests {
namespace {

golden::PtmMap read(const std::string& header, std::size_t payload) {
  return golden::parse_ptm(to_bytes(header) + counting(payload), "crafted.ptm").map;
}

/// Byte k of polynomial p of a texel; (0, 0) is the top left.
int coef(const golden::PtmMap& map, int x, int y, std::size_t p, std::size_t k) {
  const std::size_t texel = static_cast<std::size_t>(y * map.width + x);
  return map.coef[(texel * map.polynomials() + p) * 6 + k];
}

int color(const golden::PtmMap& map, int x, int y, std::size_t c) {
  return map.color[static_cast<std::size_t>(y * map.width + x) * map.color_bytes() + c];
}

TEST(RawPayload, LrgbIsABlockOfCoefficientsThenABlockOfColours) {
  const golden::PtmMap map = read(header_of("LRGB", 2, 2), 36);
  EXPECT_EQ(coef(map, 0, 1, 0, 0), 0);  // the file begins with the bottom left texel
  EXPECT_EQ(coef(map, 0, 1, 0, 5), 5);
  EXPECT_EQ(coef(map, 1, 1, 0, 0), 6);
  EXPECT_EQ(coef(map, 0, 0, 0, 0), 12);
  EXPECT_EQ(color(map, 0, 1, 0), 24);
  EXPECT_EQ(color(map, 1, 1, 2), 29);
  EXPECT_EQ(color(map, 1, 0, 2), 35);
}

TEST(RawPayload, LrgbOfVersion11IsInterleaved) {
  const golden::PtmMap map = read(header_of("LRGB", 2, 2, "PTM_1.1"), 36);
  EXPECT_EQ(coef(map, 0, 1, 0, 0), 0);
  EXPECT_EQ(color(map, 0, 1, 0), 6);
  EXPECT_EQ(coef(map, 1, 1, 0, 0), 9);
  EXPECT_EQ(color(map, 1, 0, 2), 35);
}

TEST(RawPayload, RgbIsABlockAChannel) {
  const golden::PtmMap map = read(header_of("RGB", 2, 2), 72);
  EXPECT_EQ(coef(map, 0, 1, 0, 0), 0);
  EXPECT_EQ(coef(map, 1, 1, 0, 3), 9);
  EXPECT_EQ(coef(map, 0, 1, 1, 0), 24);
  EXPECT_EQ(coef(map, 0, 1, 2, 0), 48);
  EXPECT_EQ(coef(map, 1, 0, 2, 5), 71);
  EXPECT_TRUE(map.color.empty());
}

TEST(RawPayload, LumIsInterleavedWithCrBeforeCb) {
  const golden::PtmMap map = read(header_of("LUM", 2, 2) + "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n", 32);
  EXPECT_EQ(coef(map, 0, 1, 0, 5), 5);
  EXPECT_EQ(color(map, 0, 1, 0), 6);
  EXPECT_EQ(color(map, 0, 1, 1), 7);
  EXPECT_EQ(coef(map, 1, 1, 0, 0), 8);
  EXPECT_EQ(color(map, 1, 0, 1), 31);
}

TEST(RawPayload, TruncationNamesTheByteAndBothSizes) {
  const std::string header = header_of("LRGB", 2, 2);
  const golden::InputError error = refusal_of(to_bytes(header) + counting(35));
  EXPECT_EQ(error.place(), "byte " + std::to_string(header.size() + 35) + " (payload)");
  EXPECT_EQ(error.found(), "the end of the file after 35 bytes of payload");
  EXPECT_EQ(error.expected(), "2 x 2 x 9 bytes");
}

TEST(RawPayload, TrailingBytesAreRefused) {
  const std::string header = header_of("LRGB", 2, 2);
  const golden::InputError error = refusal_of(to_bytes(header) + counting(38));
  EXPECT_EQ(error.place(), "byte " + std::to_string(header.size() + 36) + " (payload)");
  EXPECT_EQ(error.found(), "2 more bytes");
}

}  // namespace
}  // namespace ptm::tests
