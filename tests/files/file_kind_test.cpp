#include "golden/files/file_kind.h"

#include <gtest/gtest.h>

#include <string_view>

#include "golden/files/encoded_picture.h"
#include "golden/files/picture_file.h"
#include "golden/files/picture_header.h"
#include "tests/scratch_folder.h"

namespace ptm::golden {
namespace {

using namespace std::string_view_literals;
using tests::ScratchFolder;

FileKind kind_of(std::string_view bytes, const std::string& name) {
  return file_kind({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, name);
}

TEST(FileKind, TellsThePicturesThatOpenImageIoWritesByTheirFirstBytes) {
  const ScratchFolder folder;
  const std::vector<std::pair<std::string, std::string>> rows{
      {"png", "PNG"},  {"jpg", "JPEG"},         {"tif", "TIFF"},      {"exr", "OpenEXR"},
      {"bmp", "BMP"},  {"gif", "GIF"},          {"jp2", "JPEG 2000"}, {"tga", "TGA"},
      {"ppm", "PNM"},  {"hdr", "Radiance HDR"}, {"dpx", "DPX"},       {"sgi", "SGI"},
      {"webp", "WebP"}};
  for (const auto& [extension, name] : rows) {
    const std::string file = "a." + extension;
    folder.picture(file, 40, 33, 100);
    const FileKind kind = read_file_kind(folder / file, "a picture");
    EXPECT_EQ(kind.type, FileType::picture) << extension;
    EXPECT_EQ(kind.name, "a picture (" + name + ")");
    const PictureHeader header = read_picture_header(folder / file);
    EXPECT_EQ(header.width, 40) << extension;
    EXPECT_EQ(header.height, 33) << extension;
    if (extension == "tga") continue;  // it has no mark but its name
    // The bytes count, not the name.
    std::filesystem::rename(folder / file, folder / "a.wrong");
    EXPECT_EQ(read_picture(folder / "a.wrong").width, 40) << extension;
  }
}

// OpenImageIO's writer leaves 77 bytes that no program reads.
TEST(FileKind, NoJpeg2000IsWrittenThatHasNoPixels) {
  const ScratchFolder folder;
  EXPECT_THROW(folder.picture("a.jp2", 31, 40), InputError);
  EXPECT_EQ(folder.files(), 0U);
  folder.picture("a.jp2", 32, 40, 90);
  // Its wavelet is lossy: a flat picture stays flat within a level.
  EXPECT_NEAR(read_picture(folder / "a.jp2").at(31, 39, 1), 90, 1);
}

TEST(FileKind, ANameThatIsAFormatsIsNoExtension) {
  for (const char* name : {"png", "jpeg", "picture", ".png", "a.xyz", "a.ptm", "a."}) {
    EXPECT_FALSE(is_picture_extension(name)) << name;
    EXPECT_THROW(check_picture_name(name), InputError) << name;
  }
  for (const char* name : {"a.png", "png.tif", "folder.d/a.JPG"}) {
    EXPECT_TRUE(is_picture_extension(name)) << name;
  }
}

TEST(FileKind, TakesCamerasTiffsByTheirNames) {
  EXPECT_EQ(kind_of("II*\0\x08\0\0\0"sv, "a.tif").format, "tiff");
  const FileKind raw = kind_of("II*\0\x08\0\0\0"sv, "a.NEF");
  EXPECT_EQ(raw.type, FileType::picture);
  EXPECT_EQ(raw.format, "");
}

TEST(FileKind, NamesRelightablePicturesThatAreNoPtm) {
  EXPECT_EQ(kind_of("#HSH1.2\n3\n640 480 3\n9 2 1\n", "a.rti").name,
            "a relightable picture (.rti) of hemispherical harmonics (HSH): 640 x 480 texels, 3 "
            "colours, 9 terms a colour");
  EXPECT_NE(kind_of("#HSH1.2\n2\n6 4 3\n16 2 1\n", "a.rti").name.find("spherical harmonics (SH)"),
            std::string::npos);
  EXPECT_NE(kind_of("#HSH1.2\n3\n64", "a.rti").name.find("cut"), std::string::npos);
  EXPECT_NE(
      kind_of(R"({"width": 64, "height": 32, "type": "rbf", "nplanes": 12})", "info.json")
          .name.find("Relight's pictures of planes, type rbf, width 64, height 32, nplanes 12"),
      std::string::npos);
  EXPECT_NE(kind_of(" sxN\x02\0\0\0"sv, "a.nxz").name.find("Nexus"), std::string::npos);
  EXPECT_NE(kind_of("ply\nformat ascii 1.0\n", "a.ply").name.find("PLY"), std::string::npos);
  EXPECT_NE(kind_of("\x02\0\0\0\x02\0\0\0"sv, "a.hsh").name.find("HSH"), std::string::npos);
  for (const char* name : {"a.rti", "a.hsh", "info.json"}) {
    const FileKind kind = kind_of(name[0] == 'i' ? "{}" : "\x01\x02", name);
    EXPECT_EQ(kind.type, FileType::other) << name;
  }
}

TEST(FileKind, TellsTheProjectsOwnTextsByNameOrLines) {
  EXPECT_EQ(kind_of("PTM_1.2\n", "a").type, FileType::map);
  EXPECT_EQ(kind_of("# a scene\n[map]\nfile = 'a.ptm'\n", "a").type, FileType::scene);
  EXPECT_EQ(kind_of("x = 1\n", "a.toml").type, FileType::scene);
  EXPECT_EQ(kind_of("2\na.jpg 0 0 1\n", "a.txt").type, FileType::light_positions);
  // Beginnings that are also marks of pictures.
  for (const char* line : {"BM1.jpg 0 0 1\n", "P1 0 0 1\n", "#?R.png 0 0 1\n"}) {
    EXPECT_EQ(kind_of(line, "a.lp").type, FileType::light_positions) << line;
  }
  EXPECT_EQ(kind_of("BM1.jpg 0 0 1\n", "a.txt").type, FileType::light_positions);
  EXPECT_EQ(kind_of("v 0 0 1\nv 1 0 1\n", "a.txt").type, FileType::mesh);
  EXPECT_EQ(kind_of("0 0 1\n0 1 0\n", "lights.txt").type, FileType::unknown);
  EXPECT_EQ(kind_of("", "a.lp").name, "an empty file");
  EXPECT_EQ(kind_of(std::string(99, '\0'), "a.tga").name, "a file that begins with zero bytes");
}

TEST(FileKind, StatesSizesOfPicturesWhoseDecodersTakeMemoryAtOnce) {
  const ScratchFolder folder;
  const auto refused = [&](const std::string& name, std::string_view bytes) {
    const auto file = folder.write(name, std::string(bytes));
    try {
      (void)read_picture_header(file);
    } catch (const InputError& error) {
      return error.place() + ": " + error.found();
    }
    return std::string("taken");
  };
  EXPECT_EQ(refused("a.gif", "GIF89a\xff\xff\xff\xff\x80\0\0"sv), "size: 65535 x 65535");
  EXPECT_EQ(refused("a.jp2",
                    "\xff\x4f\xff\x51\0\x29\0\0\0\0\xea\x60\0\0\xea\x61\0\0\0\0\0\0\0\1"
                    "\0\0\xea\x60\0\0\xea\x60\0\0\0\0\0\0\0\0\0\1\7\1\1"sv),
            "size: 60000 x 60000");
  EXPECT_EQ(refused("a.webp", "RIFF\x40\0\0\0WEBPVP8X\x0a\0\0\0\0\0\0\0\xff\xff\xff\xff\xff\xff"sv),
            "size: 16777216 x 16777216");
  // Within the limit, and far more than the file can hold.
  EXPECT_EQ(refused("b.gif", "GIF89a\0\x40\0\x40\x80\0\0"sv),
            "size: 16384 x 16384 x 4 bytes in 13 bytes");
}

}  // namespace
}  // namespace ptm::golden
