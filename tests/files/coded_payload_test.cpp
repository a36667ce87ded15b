#include "golden/files/coded_payload.h"

#include <gtest/gtest.h>

#include "tests/files/crafted_ptm.h"

// What each plane's coded bytes become. Flat planes survive both codecs exactly.
namespace ptm::tests {
namespace {

using golden::Coding;

class CodedPayload : public testing::TestWithParam<Coding> {
 protected:
  static CraftedPlanes lrgb(int width, int height) {
    const bool jpeg = GetParam() == Coding::jpeg;
    return {GetParam(), jpeg ? "JPEG_LRGB" : "JPEGLS_LRGB", width, height};
  }
};

TEST_P(CodedPayload, PlanesAreTheCoefficientsThenRedGreenBlue) {
  CraftedPlanes file = lrgb(8, 8);
  for (std::size_t p = 0; p < 9; ++p) file.fill(p, static_cast<std::uint8_t>(10 * p + 1));
  const golden::PtmMap map = file.parse().map;
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(map.coef[k], 10 * k + 1);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(map.color[c], 10 * (6 + c) + 1);
}

TEST_P(CodedPayload, RgbPlane6cPlusKIsCoefficientKOfChannelC) {
  const bool jpeg = GetParam() == Coding::jpeg;
  CraftedPlanes file(GetParam(), jpeg ? "JPEG_RGB" : "JPEGLS_RGB", 5, 3, 18);
  for (std::size_t p = 0; p < 18; ++p) file.fill(p, static_cast<std::uint8_t>(10 * p + 1));
  const golden::PtmMap map = file.parse().map;
  for (std::size_t i = 0; i < 18 * 15; ++i) ASSERT_EQ(map.coef[i], 10 * (i % 18) + 1);
}

TEST_P(CodedPayload, PredictionWrapsModulo256AboveAndBelow) {
  CraftedPlanes file = lrgb(8, 8);
  file.fill(0, 200);
  file.fill(1, 250);  // 250 + 200 - 128 = 322 = 66 + 256
  file.references[1] = 0;
  file.fill(2, 10);
  file.fill(3, 20);  // 20 + 10 - 128 = -98 = 158 - 256
  file.references[3] = 2;
  file.fill(4, 0);  // 0 + 200 - 128 = 72, no wrap
  file.references[4] = 0;
  const golden::PtmMap map = file.parse().map;
  EXPECT_EQ(map.coef[1], 66);
  EXPECT_EQ(map.coef[3], 158);
  EXPECT_EQ(map.coef[4], 72);
}

TEST_P(CodedPayload, Transform1InvertsTheReference) {
  CraftedPlanes file = lrgb(8, 8);
  file.fill(0, 200);
  file.fill(1, 130);  // 130 + (255 - 200) - 128 = 57
  file.references[1] = 0;
  file.transforms[1] = 1;
  EXPECT_EQ(file.parse().map.coef[1], 57);
}

TEST_P(CodedPayload, InversionWithoutReferenceIsIgnoredAndNoted) {
  CraftedPlanes file = lrgb(8, 8);
  file.fill(0, 200);
  file.transforms[0] = 1;
  const golden::PtmFile read = file.parse();
  EXPECT_EQ(read.map.coef[0], 200);
  EXPECT_EQ(read.info.notes.size(), 1U);
}

TEST_P(CodedPayload, OrderIsThePositionOfThePlaneInTheSequence) {
  // A chain 2 <- 0 <- 1 that only the order "1 2 0 ..." can decode. HP's ushabti lists it so.
  CraftedPlanes file = lrgb(8, 8);
  file.order = {1, 2, 0, 3, 4, 5, 6, 7, 8};
  file.references = {2, 0, -1, -1, -1, -1, -1, -1, -1};
  file.fill(2, 100);
  file.fill(0, 138);
  file.fill(1, 133);
  const golden::PtmMap map = file.parse().map;
  EXPECT_EQ(map.coef[2], 100);
  EXPECT_EQ(map.coef[0], 110);
  EXPECT_EQ(map.coef[1], 115);
}

TEST_P(CodedPayload, SideInformationIsBigEndianAndCountsFromTheBottomRow) {
  CraftedPlanes file = lrgb(16, 20);
  file.side[0] = {0, 0, 0, 0, 7, 0, 0, 1, 2, 9};  // texel 0 and texel 258 = 16 * 16 + 2
  const golden::PtmMap map = file.parse().map;
  for (std::size_t texel = 0; texel < map.texels(); ++texel) {
    const std::size_t x = texel % 16, from_bottom = 19 - texel / 16;
    const int expected = x == 0 && from_bottom == 0 ? 7 : x == 2 && from_bottom == 16 ? 9 : 128;
    ASSERT_EQ(map.coef[6 * texel], expected) << x << ' ' << from_bottom;
  }
}

TEST_P(CodedPayload, SideInformationOverwritesTheSumAndIsSeenByLaterPlanes) {
  CraftedPlanes file = lrgb(8, 8);
  file.fill(0, 50);
  file.fill(1, 131);
  file.references[1] = 0;
  file.side[1] = {0, 0, 0, 3, 222};
  file.fill(2, 129);
  file.references[2] = 1;
  const golden::PtmMap map = file.parse().map;
  const std::size_t bottom_row = 7 * 8;
  EXPECT_EQ(map.coef[6 * (bottom_row + 2) + 1], 53);
  EXPECT_EQ(map.coef[6 * (bottom_row + 3) + 1], 222);
  EXPECT_EQ(map.coef[6 * (bottom_row + 2) + 2], 54);
  EXPECT_EQ(map.coef[6 * (bottom_row + 3) + 2], 223);
}

TEST_P(CodedPayload, StreamsRowsRunBottomUpAtAnyWidth) {
  for (const int width : {1, 3, 17}) {
    CraftedPlanes file = lrgb(width, 16);
    const auto half = static_cast<std::size_t>(width) * 8;
    // Two flat halves on block borders: exact in JPEG as well.
    for (std::size_t i = 0; i < 2 * half; ++i) file.planes[6][i] = i < half ? 30 : 220;
    const golden::PtmMap map = file.parse().map;
    for (std::size_t i = 0; i < 2 * half; ++i) {
      ASSERT_EQ(map.color[3 * i], i < half ? 220 : 30) << width;
    }
  }
}

TEST_P(CodedPayload, MotionCompensationByZeroIsNoneAndNoted) {
  CraftedPlanes file = lrgb(8, 8);
  file.fill(1, 131);
  file.references[1] = 0;
  file.transforms[1] = 2;
  const golden::PtmFile read = file.parse();
  EXPECT_EQ(read.map.coef[1], 131);
  EXPECT_EQ(read.info.notes.size(), 1U);
}

TEST_P(CodedPayload, BytesAfterAStreamsEndAreNoted) {
  CraftedPlanes file = lrgb(8, 8);
  file.streams[4] = file.stream(4) + Bytes{0, 0, 0};
  const golden::PtmFile read = file.parse();
  EXPECT_EQ(read.map.coef[4], 128);
  ASSERT_EQ(read.info.notes.size(), 1U);
  EXPECT_EQ(read.info.notes[0].substr(0, 7), "plane 4");
}

TEST_P(CodedPayload, InfoTellsWhatTheHeaderSays) {
  CraftedPlanes file = lrgb(8, 8);
  file.side[2] = {0, 0, 0, 3, 1};
  const golden::PtmFileInfo info = file.parse().info;
  EXPECT_EQ(info.coding, GetParam());
  EXPECT_EQ(info.quality, 95);
  EXPECT_EQ(info.order, file.order);
  EXPECT_EQ(info.references, file.references);
  EXPECT_EQ(info.transforms, file.transforms);
  EXPECT_EQ(info.side_bytes, (std::vector<std::uint64_t>{0, 0, 5, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(info.compressed_bytes[8], file.stream(8).size());
}

INSTANTIATE_TEST_SUITE_P(, CodedPayload, testing::Values(Coding::jpeg, Coding::jpegls),
                         coding_name);

}  // namespace
}  // namespace ptm::tests
