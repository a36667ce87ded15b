// What open_capture() and PhotoBands make of files, as the fit sees it.
#include "golden/fit/capture.h"

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <fstream>

#include "golden/files/picture_row_writer.h"
#include "golden/fit/photo_bands.h"
#include "tests/scratch_folder.h"

namespace ptm::golden {
namespace {

using tests::ScratchFolder;

std::string error_of(const CaptureRequest& request) {
  try {
    Capture capture = open_capture(request);
    Capture* const one[] = {&capture};
    PhotoBands bands(one, 1 << 20);
    Band band;
    bands.read(0, band);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

CaptureRequest request(const std::filesystem::path& lp) {
  CaptureRequest made;
  made.source = lp;
  return made;
}

/// All samples of a capture, [photograph][channel][texel], read in bands of one row.
std::vector<float> samples_of(const CaptureRequest& asked, SampleCounts* counts = nullptr) {
  Capture capture = open_capture(asked);
  Capture* const one[] = {&capture};
  PhotoBands bands(one, 1);
  const auto texels = static_cast<std::size_t>(capture.region.width * capture.region.height);
  const auto width = static_cast<std::size_t>(capture.region.width);
  std::vector<float> samples(capture.names.size() * 3 * texels);
  Band band;
  for (int b = 0; b < bands.bands(); ++b) {
    bands.read(b, band);
    for (std::size_t p = 0; p < capture.names.size() * 3; ++p) {
      std::copy_n(
          band.samples.begin() + static_cast<std::ptrdiff_t>(p * band.texels), band.texels,
          samples.begin() + static_cast<std::ptrdiff_t>(
                                p * texels + static_cast<std::size_t>(band.first_row) * width));
    }
  }
  if (counts != nullptr) *counts = bands.counts();
  return samples;
}

/// A grey float picture, little endian (Portable Float Map, rows bottom-up).
void write_pfm(const std::filesystem::path& path, int width, int height,
               const std::vector<float>& samples) {
  std::ofstream out(path, std::ios::binary);
  out << "Pf\n" << width << ' ' << height << "\n-1.0\n";
  out.write(reinterpret_cast<const char*>(samples.data()),
            static_cast<std::streamsize>(samples.size() * sizeof(float)));
}

TEST(Capture, KeepsOrderAndLevelsOfThePhotographs) {
  const ScratchFolder folder;
  folder.picture("a.png", 4, 3, 10);
  folder.picture("b.png", 4, 3, 200);
  const auto lp = folder.write("c.lp", "b.png 0 0 1\na.png 0.6 0 0.8\n");
  const Capture capture = open_capture(request(lp));
  EXPECT_EQ(capture.region.width, 4);
  EXPECT_EQ(capture.region.height, 3);
  EXPECT_EQ(capture.names, (std::vector<std::string>{"b.png", "a.png"}));
  EXPECT_EQ(capture.directions[1][0], 0.6);
  std::vector<float> expected(36, 200);
  expected.resize(72, 10);
  EXPECT_EQ(samples_of(request(lp)), expected);
}

TEST(Capture, TurnsGreyPhotographsIntoThreeEqualChannels) {
  const ScratchFolder folder;
  Image8 grey(2, 1, 1);
  grey.samples = {7, 9};
  write_picture(folder / "g.png", grey);
  EXPECT_EQ(samples_of(request(folder.write("c.lp", "g.png 0 0 1\n"))),
            (std::vector<float>{7, 9, 7, 9, 7, 9}));
}

TEST(Capture, ReadsSixteenBitAndFloatPictures) {
  const ScratchFolder folder;
  const std::array<std::uint16_t, 2> wide{257, 65535};
  const auto output = OIIO::ImageOutput::create("w.png");
  ASSERT_TRUE(
      output->open((folder / "w.png").string(), OIIO::ImageSpec(2, 1, 1, OIIO::TypeDesc::UINT16)));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT16, wide.data()) && output->close());
  SampleCounts counts;
  EXPECT_EQ(samples_of(request(folder.write("w.lp", "w.png 0 0 1\n")), &counts),
            (std::vector<float>{1, 255, 1, 255, 1, 255}));
  EXPECT_EQ(counts.saturated, 3U);
  write_pfm(folder / "f.pfm", 3, 1, {0.5F, 2, -1});
  EXPECT_EQ(samples_of(request(folder.write("f.lp", "f.pfm 0 0 1\n")), &counts),
            (std::vector<float>{127.5F, 510, 0, 127.5F, 510, 0, 127.5F, 510, 0}));
  EXPECT_EQ(counts.saturated, 3U);
  EXPECT_EQ(counts.negative, 3U);
}

TEST(Capture, DecodesSrgbWhenLinearLightIsAskedFor) {
  const ScratchFolder folder;
  Image8 grey(3, 1, 1);
  grey.samples = {0, 188, 255};
  write_picture(folder / "g.png", grey);
  CaptureRequest linear = request(folder.write("c.lp", "g.png 0 0 1\n"));
  linear.linear = true;
  const std::vector<float> samples = samples_of(linear);
  EXPECT_EQ(samples[0], 0);
  EXPECT_NEAR(samples[1], 255 * 0.502886, 1e-3);  // sRGB 188 is half the light
  EXPECT_EQ(samples[2], 255);
}

TEST(Capture, CropsToARegionAndReadsItRowByRow) {
  const ScratchFolder folder;
  Image8 picture(5, 4, 3);
  for (std::size_t n = 0; n < picture.samples.size(); ++n) {
    picture.samples[n] = static_cast<std::uint8_t>(n);
  }
  write_picture(folder / "p.png", picture);
  CaptureRequest part = request(folder.write("c.lp", "p.png 0 0 1\n"));
  part.region = Region{1, 1, 3, 2};
  std::vector<float> expected;
  for (int c = 0; c < 3; ++c) {
    for (int y = 1; y < 3; ++y) {
      for (int x = 1; x < 4; ++x) expected.push_back(picture.at(x, y, c));
    }
  }
  EXPECT_EQ(samples_of(part), expected);
  for (const Region r : {Region{0, 0, 6, 1}, Region{-1, 0, 2, 2}, Region{4, 3, 1, 2},
                         Region{0, 0, 0, 1}, Region{2147483647, 0, 2, 1}}) {
    part.region = r;
    EXPECT_NE(error_of(part).find("within 5 x 4 pixels"), std::string::npos);
  }
}

TEST(Capture, ReadsJpegsByRowsAsItReadsThemWhole) {
  const ScratchFolder folder;
  PictureRowWriter writer(folder / "p.jpg", 37, 50, 3);
  std::vector<std::uint8_t> samples(37 * 50 * 3);
  for (std::size_t n = 0; n < samples.size(); ++n) {
    samples[n] = static_cast<std::uint8_t>(n * n / 7 % 251);
  }
  writer.write(std::span(samples).first(37 * 3 * 20));
  writer.write(std::span(samples).subspan(37 * 3 * 20));
  writer.commit();
  const ImageReal whole = read_picture(folder / "p.jpg");
  const std::vector<float> rows = samples_of(request(folder.write("c.lp", "p.jpg 0 0 1\n")));
  for (std::size_t n = 0; n < whole.samples.size(); ++n) {
    ASSERT_EQ(rows[n % 3 * (37 * 50) + n / 3], whole.samples[n]) << n;
  }
  EXPECT_TRUE(PictureRows(folder / "p.jpg", false).streams());
}

/// 1 2 3 over 4 5 6, and the tag that says how to turn it.
void write_turned(const std::filesystem::path& path, int tag, bool tiled) {
  OIIO::ImageSpec spec(3, 2, 1, OIIO::TypeDesc::UINT8);
  spec.attribute("Orientation", tag);
  if (tiled) spec.tile_width = spec.tile_height = 16;
  const auto output = OIIO::ImageOutput::create(path.string());
  const std::array<std::uint8_t, 6> samples{1, 2, 3, 4, 5, 6};
  ASSERT_TRUE(output->open(path.string(), spec));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, samples.data()) && output->close());
}

TEST(Capture, TurnsPhotographsAsTheirTagSays) {
  const ScratchFolder folder;
  // What Exif (tag 0x0112) says of the stored rows 1 2 3 and 4 5 6, one a line.
  const std::vector<std::vector<float>> upright{
      {1, 2, 3, 4, 5, 6}, {3, 2, 1, 6, 5, 4}, {6, 5, 4, 3, 2, 1}, {4, 5, 6, 1, 2, 3},
      {1, 4, 2, 5, 3, 6}, {4, 1, 5, 2, 6, 3}, {6, 3, 5, 2, 4, 1}, {3, 6, 2, 5, 1, 4}};
  for (const bool tiled : {false, true}) {
    for (int tag = 0; tag <= 9; ++tag) {
      const bool applies = tag >= 1 && tag <= 8;
      const std::vector<float>& wanted = upright[applies ? static_cast<std::size_t>(tag) - 1 : 0];
      write_turned(folder / "t.tif", tag, tiled);
      CaptureRequest asked = request(folder.write("c.lp", "t.tif 0 0 1\n"));
      const Capture capture = open_capture(asked);
      EXPECT_EQ(capture.region.width, applies && tag >= 5 ? 2 : 3) << tag;
      EXPECT_EQ(capture.notes.empty(), !applies || tag == 1) << tag;
      EXPECT_EQ(PictureRows(folder / "t.tif", false).streams(), !tiled);
      std::vector<float> samples = samples_of(asked);  // in bands of one row
      samples.resize(6);
      EXPECT_EQ(samples, wanted) << tag;
      const ImageReal picture = read_picture(folder / "t.tif");
      EXPECT_EQ(std::vector<float>(picture.samples.begin(), picture.samples.end()), wanted);
      // The last row of the upright picture alone.
      const int width = capture.region.width, height = capture.region.height;
      asked.region = Region{1, height - 1, width - 1, 1};
      samples = samples_of(asked);
      samples.resize(static_cast<std::size_t>(width) - 1);
      EXPECT_EQ(samples, std::vector<float>(wanted.end() - width + 1, wanted.end())) << tag;
      asked.region.reset();
      asked.as_stored = true;
      samples = samples_of(asked);
      samples.resize(6);
      EXPECT_EQ(samples, upright[0]);
      EXPECT_TRUE(open_capture(asked).notes.empty());
    }
  }
}

TEST(Capture, TurnsALargePhotographStripByStrip) {
  const ScratchFolder folder;
  OIIO::ImageSpec spec(90, 300, 3, OIIO::TypeDesc::UINT8);
  std::vector<std::uint8_t> samples(90 * 300 * 3);
  for (std::size_t n = 0; n < samples.size(); ++n) {
    samples[n] = static_cast<std::uint8_t>(n * n / 11 % 253);
  }
  for (const int tag : {1, 3, 6, 7, 8}) {
    spec.attribute("Orientation", tag);
    const auto output = OIIO::ImageOutput::create("p.jpg");
    ASSERT_TRUE(output->open((folder / "p.jpg").string(), spec));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, samples.data()) && output->close());
    PictureRows rows(folder / "p.jpg", false);
    EXPECT_EQ(rows.orientation(), tag);
    EXPECT_TRUE(rows.streams());
    EXPECT_EQ(rows.decodes_once(), tag == 1);
    const ImageReal whole = read_picture(folder / "p.jpg");
    ASSERT_EQ(whole.width, tag >= 5 ? 300 : 90);
    const std::vector<float> read = samples_of(request(folder.write("c.lp", "p.jpg 0 0 1\n")));
    for (std::size_t n = 0; n < whole.samples.size(); ++n) {
      ASSERT_EQ(read[n % 3 * (90 * 300) + n / 3], whole.samples[n]) << tag << " at " << n;
    }
  }
}

TEST(Capture, SaysWhenTagsOfOneCameraDiffer) {
  const ScratchFolder folder;
  write_turned(folder / "a.tif", 1, false);
  write_turned(folder / "b.tif", 3, false);
  write_turned(folder / "c.tif", 6, false);
  const Capture half =
      open_capture(request(folder.write("h.lp", "a.tif 0 0 1\nb.tif 0.6 0 0.8\n")));
  ASSERT_EQ(half.notes.size(), 1U);
  EXPECT_NE(half.notes[0].find("1 with 1, 1 with 3; of a camera that stood still"),
            std::string::npos)
      << half.notes[0];
  CaptureRequest quarter = request(folder.write("q.lp", "a.tif 0 0 1\nc.tif 0.6 0 0.8\n"));
  EXPECT_NE(error_of(quarter).find("line 2: found c.tif of 2 x 3 pixels, expected 3 x 2 like the "
                                   "first photograph, whose tag Orientation differs"),
            std::string::npos)
      << error_of(quarter);
  quarter.as_stored = true;
  EXPECT_EQ(error_of(quarter), "no error");
}

TEST(Capture, NamesTheLineOfAPhotographOfAnotherSize) {
  const ScratchFolder folder;
  folder.picture("a.png", 4, 3);
  folder.picture("b.png", 3, 4);
  const std::string error =
      error_of(request(folder.write("c.lp", "2\na.png 0 0 1\nb.png 0.6 0 0.8\n")));
  EXPECT_NE(error.find("line 3: found b.png of 3 x 4 pixels, expected 4 x 3"), std::string::npos)
      << error;
}

TEST(Capture, NamesThePhotographThatIsNoPictureOrEndsEarlyOrHoldsNoLight) {
  const ScratchFolder folder;
  folder.picture("a.png", 64, 64);
  folder.write("text.png", "this is no picture");
  PictureRowWriter writer(folder / "whole.jpg", 64, 64, 3);
  std::vector<std::uint8_t> samples(64 * 64 * 3);
  for (std::size_t n = 0; n < samples.size(); ++n) samples[n] = static_cast<std::uint8_t>(n * 37);
  writer.write(samples);
  writer.commit();
  std::ifstream in(folder / "whole.jpg", std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), {});
  folder.write("half.jpg", bytes.substr(0, bytes.size() / 2));
  write_pfm(folder / "nan.pfm", 64, 64, std::vector<float>(64 * 64, NAN));
  for (const char* bad : {"text.png", "half.jpg", "nan.pfm"}) {
    const auto lp = folder.write("c.lp", std::string("a.png 0 0 1\n") + bad + " 0.6 0 0.8\n");
    EXPECT_NE(error_of(request(lp)).find(bad), std::string::npos) << bad;
  }
}

TEST(Capture, WantsAFolderWithATableAndATableWithAFolder) {
  const ScratchFolder folder;
  folder.picture("a.png");
  CaptureRequest asked = request(folder / "");
  EXPECT_NE(error_of(asked).find("--lights TABLE"), std::string::npos);
  asked.source = folder.write("c.lp", "a.png 0 0 1\n");
  asked.lights = folder.write("t.txt", "0 0 1\n");
  EXPECT_NE(error_of(asked).find("found no folder"), std::string::npos);
}

TEST(Capture, RefusesAPictureThatTwoLightsShareUnlessAskedTo) {
  const ScratchFolder folder;
  PictureRowWriter picture(folder / "p.png", 2, 2);
  picture.write(std::vector<std::uint8_t>{1, 2, 3, 4});
  picture.commit();
  std::filesystem::create_symlink("p.png", folder / "link.png");
  const auto list = [&](const std::string& second) {
    return request(folder.write("capture.lp", "2\na/p.png 0 0 1\n" + second + " 0.6 0 0.8\n"));
  };
  // A folder that is missing, the same name, a link, and a way round.
  for (const std::string second : {"b\\p.png", "p.png", "link.png", "./p.png"}) {
    CaptureRequest asked = list(second);
    const std::string error = error_of(asked);
    EXPECT_NE(error.find("line 3: found the picture"), std::string::npos) << error;
    EXPECT_NE(error.find("which line 2 has already"), std::string::npos) << error;
    asked.share_pictures = true;
    EXPECT_EQ(error_of(asked), "no error");
  }
}

}  // namespace
}  // namespace ptm::golden
