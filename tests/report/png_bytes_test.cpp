#include "golden/files/png_bytes.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace ptm::golden {
namespace {

Image8 pattern(int width, int height, int channels) {
  Image8 image(width, height, channels);
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    image.samples[i] = static_cast<std::uint8_t>(i * i * 31 + i);
  }
  return image;
}

TEST(PngBytes, AreReadBackAsThePictureThatWasEncoded) {
  for (const int channels : {1, 3}) {
    const Image8 image = pattern(37, 21, channels);
    std::vector<std::uint8_t> png = encode_png(image);
    OIIO::Filesystem::IOMemReader reader(png.data(), png.size());
    const auto input = OIIO::ImageInput::open("x.png", nullptr, &reader);
    ASSERT_TRUE(input) << OIIO::geterror();
    ASSERT_EQ(input->spec().width, 37);
    ASSERT_EQ(input->spec().height, 21);
    ASSERT_EQ(input->spec().nchannels, channels);
    std::vector<std::uint8_t> back(image.samples.size());
    ASSERT_TRUE(input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, back.data()));
    EXPECT_EQ(back, image.samples);
  }
}

TEST(PngBytes, AreTheSameForTheSamePicture) {
  EXPECT_EQ(encode_png(pattern(16, 16, 3)), encode_png(pattern(16, 16, 3)));
}

TEST(PngBytes, AreRefusedForPicturesThatPngCannotHold) {
  EXPECT_THROW((void)encode_png(Image8()), std::invalid_argument);
  EXPECT_THROW((void)encode_png(pattern(4, 4, 2)), std::invalid_argument);
}

}  // namespace
}  // namespace ptm::golden
