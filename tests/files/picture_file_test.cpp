#include "golden/files/picture_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include "tests/files/crafted_ptm.h"
#include "tests/scratch_folder.h"

namespace ptm::tests {
namespace {

using golden::Image8;
using golden::ImageReal;
using golden::InputError;

Image8 made_image(int width, int height, int channels) {
  Image8 image(width, height, channels);
  std::mt19937 random(4);
  for (auto& sample : image.samples) sample = static_cast<std::uint8_t>(random() & 255U);
  return image;
}

Bytes bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void put(const std::filesystem::path& path, const Bytes& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

template <class Sample>
void put_picture(const std::filesystem::path& path, int channels, OIIO::TypeDesc type,
                 const std::vector<Sample>& samples) {
  const auto output = OIIO::ImageOutput::create(path.string());
  OIIO::ImageSpec spec(1, 1, channels, type);
  spec["oiio:UnassociatedAlpha"] = 1;
  ASSERT_TRUE(output->open(path.string(), spec));
  ASSERT_TRUE(output->write_image(type, samples.data()));
  ASSERT_TRUE(output->close());
}

TEST(PictureFile, PngKeepsEverySampleAndItsPlace) {
  ScratchFolder folder;
  for (const int channels : {1, 3}) {
    const Image8 image = made_image(7, 5, channels);
    golden::write_picture(folder / "a.png", image);
    const ImageReal read = golden::read_picture(folder / "a.png");
    ASSERT_EQ(read.channels, channels);
    ASSERT_EQ(read.width, 7);
    ASSERT_EQ(read.height, 5);
    for (std::size_t i = 0; i < image.samples.size(); ++i) {
      ASSERT_EQ(read.samples[i], image.samples[i]);
    }
  }
  EXPECT_EQ(folder.files(), 1U);
}

TEST(PictureFile, PngIsTheSameBytesAtAnotherTime) {
  ScratchFolder folder;
  golden::write_picture(folder / "a.png", made_image(7, 5, 3));
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // PNG's clock counts seconds
  golden::write_picture(folder / "b.png", made_image(7, 5, 3));
  EXPECT_EQ(bytes_of(folder / "a.png"), bytes_of(folder / "b.png"));
}

TEST(PictureFile, AlphaIsDroppedAndNotMultipliedIn) {
  ScratchFolder folder;
  put_picture(folder / "a.png", 4, OIIO::TypeDesc::UINT8, Bytes{200, 100, 50, 128});
  const ImageReal read = golden::read_picture(folder / "a.png");
  EXPECT_EQ(read.channels, 3);
  EXPECT_EQ(read.samples, (std::vector<double>{200, 100, 50}));
  put_picture(folder / "b.png", 2, OIIO::TypeDesc::UINT8, Bytes{200, 128});
  EXPECT_EQ(golden::read_picture(folder / "b.png").samples, std::vector<double>{200});
}

TEST(PictureFile, DeepSamplesAreScaledWithoutRounding) {
  ScratchFolder folder;
  put_picture(folder / "a.png", 1, OIIO::TypeDesc::UINT16, std::vector<std::uint16_t>{1000});
  EXPECT_EQ(golden::read_picture(folder / "a.png").samples[0], 1000.0 * 255 / 65535);
  put_picture(folder / "a.tif", 1, OIIO::TypeDesc::FLOAT, std::vector<float>{0.125F});
  EXPECT_EQ(golden::read_picture(folder / "a.tif").samples[0], 0.125 * 255);
}

TEST(PictureFile, NanIsRefused) {
  ScratchFolder folder;
  put_picture(folder / "a.tif", 1, OIIO::TypeDesc::FLOAT,
              std::vector<float>{std::numeric_limits<float>::quiet_NaN()});
  EXPECT_THROW((void)golden::read_picture(folder / "a.tif"), InputError);
}

TEST(PictureFile, BrokenPicturesAreRefusedByName) {
  ScratchFolder folder;
  const Image8 image = made_image(60, 50, 3);
  for (const char* name : {"a.png", "a.jpg", "a.tif"}) {
    golden::write_picture(folder / name, image);
    const Bytes whole = bytes_of(folder / name);
    for (const double share : {0.0, 0.1, 0.5, 0.9}) {
      const auto size = static_cast<std::ptrdiff_t>(share * static_cast<double>(whole.size()));
      put(folder / name, Bytes(whole.begin(), whole.begin() + size));
      try {
        (void)golden::read_picture(folder / name);
        ADD_FAILURE() << name << " cut to " << share << " was accepted";
      } catch (const InputError& error) {
        EXPECT_EQ(error.file(), (folder / name).string());
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      }
    }
  }
}

TEST(PictureFile, MissingFilesFoldersAndTextAreRefused) {
  ScratchFolder folder;
  EXPECT_THROW((void)golden::read_picture(folder / "none.png"), InputError);
  std::filesystem::create_directory(folder / "folder.png");
  EXPECT_THROW((void)golden::read_picture(folder / "folder.png"), InputError);
  put(folder / "text.png", to_bytes("not a picture"));
  EXPECT_THROW((void)golden::read_picture(folder / "text.png"), InputError);
}

TEST(PictureFile, AbsurdSizesAreRefusedBeforeTheyTakeMemory) {
  ScratchFolder folder;
  golden::write_picture(folder / "a.png", made_image(4, 4, 3));
  Bytes bytes = bytes_of(folder / "a.png");
  // IHDR's width and height, 16000 each; the CRC is libpng's business, both ways are refusals.
  for (const std::size_t at : {16U, 20U}) {
    bytes[at] = bytes[at + 1] = 0;
    bytes[at + 2] = 0x3e;
    bytes[at + 3] = 0x80;
  }
  put(folder / "a.png", bytes);
  EXPECT_THROW((void)golden::read_picture(folder / "a.png"), InputError);
}

TEST(PictureFile, UnwritableTargetsLeaveNothingBehind) {
  ScratchFolder folder;
  EXPECT_THROW(golden::write_picture(folder / "a.none", made_image(2, 2, 3)), InputError);
  EXPECT_THROW(golden::write_picture(folder / "none" / "a.png", made_image(2, 2, 3)), InputError);
  EXPECT_THROW(golden::write_picture(folder / "a.png", made_image(2, 2, 4)), std::invalid_argument);
  EXPECT_EQ(folder.files(), 0U);
}

}  // namespace
}  // namespace ptm::tests
