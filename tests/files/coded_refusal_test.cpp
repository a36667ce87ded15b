#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <algorithm>

#include "tests/files/crafted_ptm.h"

// Coded files that are refused, and by which words.
namespace ptm::tests {
namespace {

using golden::Coding;
using golden::InputError;

class CodedRefusal : public testing::TestWithParam<Coding> {
 protected:
  static bool jpeg() { return GetParam() == Coding::jpeg; }
  static CraftedPlanes lrgb(int width, int height) {
    return {GetParam(), jpeg() ? "JPEG_LRGB" : "JPEGLS_LRGB", width, height};
  }
  /// Writes another size into a stream's frame header (T.81 B.2.2, T.87 C.2.2).
  static void claim(Bytes& stream, int width, int height) {
    const Bytes marker{0xff, static_cast<std::uint8_t>(jpeg() ? 0xc0 : 0xf7)};
    const auto at = std::search(stream.begin(), stream.end(), marker.begin(), marker.end());
    ASSERT_NE(at, stream.end());
    at[5] = static_cast<std::uint8_t>(height >> 8);
    at[6] = static_cast<std::uint8_t>(height & 255);
    at[7] = static_cast<std::uint8_t>(width >> 8);
    at[8] = static_cast<std::uint8_t>(width & 255);
  }
};

TEST_P(CodedRefusal, MotionVectors) {
  CraftedPlanes file = lrgb(8, 8);
  file.transforms[3] = 2;
  file.motion_y[3] = -4;
  const InputError error = refusal_of(file.bytes());
  EXPECT_EQ(error.place(), "line 8 (transforms)");
  EXPECT_EQ(error.found(), "motion compensation by (0, -4) in plane 3");
}

TEST_P(CodedRefusal, UnknownTransforms) {
  for (const int transform : {-1, 3}) {
    CraftedPlanes file = lrgb(8, 8);
    file.transforms[3] = transform;
    EXPECT_EQ(refusal_of(file.bytes()).place(), "line 8 (transforms)");
  }
}

TEST_P(CodedRefusal, OrdersThatAreNoPermutation) {
  CraftedPlanes file = lrgb(8, 8);
  file.order[3] = 4;
  EXPECT_EQ(refusal_of(file.bytes()).found(), "position 4 twice");
  for (const int position : {-1, 9}) {
    file.order[3] = position;
    EXPECT_EQ(refusal_of(file.bytes()).place(), "line 11 (order)");
  }
}

TEST_P(CodedRefusal, ReferencesToItselfToLaterPlanesInCirclesAndOutOfRange) {
  CraftedPlanes file = lrgb(8, 8);
  file.references[3] = 3;
  EXPECT_EQ(refusal_of(file.bytes()).found(), "plane 3 built on plane 3, decoded no earlier");
  file.references[3] = 4;
  EXPECT_EQ(refusal_of(file.bytes()).found(), "plane 3 built on plane 4, decoded no earlier");
  file.references[4] = 3;  // a circle: whatever the order, one of the two comes first
  EXPECT_EQ(refusal_of(file.bytes()).place(), "line 12 (references)");
  for (const int reference : {-2, 9}) {
    file = lrgb(8, 8);
    file.references[3] = reference;
    EXPECT_EQ(refusal_of(file.bytes()).place(), "line 12 (references)");
  }
}

TEST_P(CodedRefusal, StreamsOfAnotherSize) {
  CraftedPlanes file = lrgb(8, 8);
  file.streams[2] = lrgb(8, 9).stream(0);
  const InputError error = refusal_of(file.bytes());
  EXPECT_EQ(error.place().substr(0, 16), "plane 2 at byte ");
  EXPECT_EQ(error.found(), "a stream of 8 x 9");
  EXPECT_EQ(error.expected(), "8 x 8 as the header says");
}

TEST_P(CodedRefusal, StreamsOfTheOtherCodec) {
  CraftedPlanes file = lrgb(8, 8);
  file.streams[2] = jpeg() ? golden::encode_jpegls_plane(file.planes[2], 8, 8)
                           : golden::encode_jpeg_plane(file.planes[2], 8, 8, 100);
  EXPECT_EQ(refusal_of(file.bytes()).found().substr(0, 6), "broken");
}

TEST_P(CodedRefusal, StreamsCutShortOrWithGarbageInside) {
  CraftedPlanes file = lrgb(64, 64);
  for (std::size_t i = 0; i < file.planes[5].size(); ++i) {
    file.planes[5][i] = static_cast<std::uint8_t>(i * 37 + i / 7);
  }
  const Bytes whole = file.stream(5);
  for (std::size_t size = 1; size < whole.size(); size += 97) {
    file.streams[5] = Bytes(whole.begin(), whole.begin() + static_cast<int>(size));
    EXPECT_EQ(refusal_of(file.bytes()).place().substr(0, 7), "plane 5") << size;
  }
  file.streams[5] = Bytes(whole.size(), 0xff);
  EXPECT_EQ(refusal_of(file.bytes()).place().substr(0, 7), "plane 5");
}

TEST_P(CodedRefusal, ShortStreamsThatClaimMoreThanTheyCanHold) {
  CraftedPlanes small = lrgb(8, 8);
  Bytes stream = small.stream(0);
  claim(stream, 4000, 4000);
  CraftedPlanes file = lrgb(1, 1);
  file.streams.assign(9, stream);
  file.width = file.height = 4000;
  const InputError error = refusal_of(file.bytes());
  EXPECT_EQ(error.found(), std::to_string(stream.size()) + " bytes for 4000 x 4000 texels");
  // 500 x 500 blocks of 1 bit; 4000 rows of 1 bit.
  EXPECT_EQ(error.expected(), jpeg() ? "at least 31250 bytes" : "at least 500 bytes");
}

// Nine planes of 16000 x 16000 take 2.3 GB: refused by the header, before any stream is looked at.
TEST_P(CodedRefusal, SmallFilesThatClaimGigabytes) {
  CraftedPlanes small = lrgb(8, 8);
  Bytes stream = small.stream(0);
  claim(stream, 16000, 16000);
  CraftedPlanes file = lrgb(1, 1);
  file.streams.assign(9, stream);
  file.width = file.height = 16000;
  const InputError error = refusal_of(file.bytes());
  EXPECT_EQ(error.place(), "width and height");
  EXPECT_EQ(error.found(),
            "16000 x 16000 texels in a file of " + std::to_string(file.bytes().size()) + " bytes");
}

TEST_P(CodedRefusal, PlanesAbove2To28Texels) {
  CraftedPlanes small = lrgb(8, 8);
  Bytes stream = small.stream(0);
  claim(stream, 65500, 65500);
  CraftedPlanes file = lrgb(1, 1);
  file.streams.assign(9, stream);
  file.width = file.height = 65500;
  EXPECT_EQ(refusal_of(file.bytes()).expected(), "at most 268435456 texels in a coded file");
}

TEST_P(CodedRefusal, SizesThatDoNotAddUpToTheFile) {
  const CraftedPlanes file = lrgb(8, 8);
  Bytes longer = file.bytes();
  longer.push_back(0);
  EXPECT_NE(refusal_of(longer).expected().find("sum of the listed sizes"), std::string::npos);
  Bytes shorter = file.bytes();
  shorter.pop_back();
  EXPECT_NE(refusal_of(shorter).expected().find("sum of the listed sizes"), std::string::npos);
}

TEST_P(CodedRefusal, SideInformationOfOddSizeOrOutsideThePlane) {
  CraftedPlanes file = lrgb(8, 8);
  file.side[1] = {0, 0, 0, 0};
  EXPECT_EQ(refusal_of(file.bytes()).place(), "line 14 (side information sizes)");
  file.side[1] = {0, 0, 0, 63, 1, 0, 0, 0, 64, 1};
  const InputError error = refusal_of(file.bytes());
  EXPECT_EQ(error.found(), "texel 64");
  EXPECT_EQ(error.expected(), "a number below 64");
}

TEST_P(CodedRefusal, HeaderListsOfTheWrongLength) {
  CraftedPlanes file = lrgb(8, 8);
  file.references.push_back(-1);
  EXPECT_EQ(refusal_of(file.bytes()).found(), "10 words");
  file = lrgb(8, 8);
  file.motion_x.pop_back();
  EXPECT_EQ(refusal_of(file.bytes()).place(), "line 9 (motion x)");
}

TEST_P(CodedRefusal, StreamsCutShortButEndedWithAMarker) {
  CraftedPlanes file = lrgb(16, 16);
  for (std::size_t i = 0; i < file.planes[5].size(); ++i) {
    file.planes[5][i] = static_cast<std::uint8_t>(i * 37 + i / 7);
  }
  const Bytes whole = file.stream(5);
  for (std::size_t size = 0; size + 2 < whole.size() * 3 / 4; ++size) {
    file.streams[5] =
        Bytes(whole.begin(), whole.begin() + static_cast<int>(size)) + Bytes{0xff, 0xd9};
    EXPECT_EQ(refusal_of(file.bytes()).place().substr(0, 7), "plane 5") << size;
  }
}

INSTANTIATE_TEST_SUITE_P(, CodedRefusal, testing::Values(Coding::jpeg, Coding::jpegls),
                         coding_name);

TEST(JpegRefusal, StreamsInColour) {
  const Bytes pixels(8 * 8 * 3, 100);
  const auto handle = tjInitCompress();
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  ASSERT_EQ(tjCompress2(handle, pixels.data(), 8, 0, 8, TJPF_RGB, &buffer, &size, TJSAMP_444, 90,
                        TJFLAG_ACCURATEDCT),
            0);
  CraftedPlanes file(Coding::jpeg, "JPEG_LRGB", 8, 8);
  file.streams[7].assign(buffer, buffer + size);
  tjFree(buffer);
  tjDestroy(handle);
  EXPECT_EQ(refusal_of(file.bytes()).found(), "a JPEG stream in colour");
}

TEST(JpegLsRefusal, StreamsOfOtherThan8Bits) {
  CraftedPlanes file(Coding::jpegls, "JPEGLS_LRGB", 8, 8);
  Bytes stream = file.stream(0);
  const Bytes marker{0xff, 0xf7};
  const auto at = std::search(stream.begin(), stream.end(), marker.begin(), marker.end());
  at[4] = 12;
  file.streams[0] = stream;
  EXPECT_EQ(refusal_of(file.bytes()).found(), "1 component of 12 bits");
}

}  // namespace
}  // namespace ptm::tests
