#include <nlohmann/json.hpp>

#include "golden/files/picture_file.h"
#include "golden/files/picture_row_writer.h"
#include "tests/files/crafted_ptm.h"
#include "tests/program/small_map.h"
#include "tests/run_measured.h"
#include "tests/run_program.h"

// `ptmsim info` reads first bytes, then headers, and data only with --all.
namespace ptm {
namespace {

using Json = nlohmann::json;

class InfoCommand : public tests::Program {
 protected:
  /// A file of `size` bytes of which all but `head` are zeros that take no room.
  std::filesystem::path sparse(const std::string& name, const std::string& head,
                               std::uintmax_t size) const {
    const auto path = write(name, head);
    std::filesystem::resize_file(path, size);
    return path;
  }
  [[nodiscard]] Json described(const std::filesystem::path& path,
                               const std::string& options = "") const {
    const tests::Outcome outcome = run("info --json " + options + " " + tests::quoted(path));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out, nullptr, false);
  }
  /// `info` takes no more memory for the file than for a tiny map, within a quarter of `data`.
  void expect_headers_only(const std::filesystem::path& path, std::uintmax_t data) const {
    const auto tiny = file("tiny.ptm");
    golden::write_ptm(tiny, tests::small_map(golden::MapKind::lrgb, 2, 2));
    const tests::Measured least = tests::run_measured({"info", tiny.string()});
    const tests::Measured large = tests::run_measured({"info", path.string()});
    EXPECT_EQ(large.code, 0);
    EXPECT_LT(large.peak_kib, least.peak_kib + static_cast<long>(data / 4 / 1024));
  }
};

// Any reader that went through them all would take minutes.
TEST_F(InfoCommand, JudgesTheFirstBytesOfAHugeFileAlone) {
  const std::uintmax_t size = std::uintmax_t{1} << 36;
  expect_refused("info " + tests::quoted(sparse("zeros", "", size)), "begins with zero bytes");
  for (const char* name : {"zeros.png", "zeros.tga", "zeros.ico"}) {
    const auto zeros = tests::quoted(sparse(name, "", size));
    expect_refused("info " + zeros, "begins with zero bytes");
    expect_refused("bump " + zeros + " --out " + tests::quoted(file("o.ptm")), "PNG, JPEG");
  }
  expect_refused("info " + tests::quoted(sparse("zeros.ptm", "", size)), "zeros.ptm");
}

TEST_F(InfoCommand, ReadsTheHeaderOfALargeMapAlone) {
  const std::uintmax_t texels = 100'000'000;
  const std::string header = "PTM_1.2\nPTM_FORMAT_LRGB\n10000\n10000\n1 1 1 1 1 1\n0 0 0 0 0 0\n";
  const auto map = sparse("large.ptm", header, header.size() + 9 * texels);
  expect_headers_only(map, 9 * texels);
  const Json info = described(map);
  EXPECT_EQ(info["width"], 10000);
  EXPECT_EQ(info["payload_bits_per_texel"], 72.0);
  EXPECT_FALSE(info.contains("bytes"));
  // A header that promises more than the file has is refused as before.
  std::filesystem::resize_file(map, header.size() + 9 * texels - 1);
  expect_refused("info " + tests::quoted(map), "(payload)");
}

TEST_F(InfoCommand, ReadsTheHeaderOfALargePictureAlone) {
  const auto path = file("large.png");
  constexpr int side = 8192;
  golden::PictureRowWriter writer(path, side, side, 1);
  const std::vector<std::uint8_t> rows(std::size_t{side} * 512, 7);
  for (int y = 0; y < side; y += 512) writer.write(rows);
  writer.commit();
  expect_headers_only(path, std::uintmax_t{side} * side);
  const Json info = described(path);
  EXPECT_EQ(info["format"], "picture");
  EXPECT_EQ(info["width"], side);
  EXPECT_EQ(info["samples"], "uint8");
  EXPECT_FALSE(info.contains("levels"));
  const Json all = described(path, "--all");
  EXPECT_EQ(all["levels"][0]["min"], 7.0);
  EXPECT_EQ(all["levels"][0]["max"], 7.0);
}

TEST_F(InfoCommand, DecodesPlanesAndPixelsOnlyIfAsked) {
  tests::CraftedPlanes planes(golden::Coding::jpeg, "JPEG_LRGB", 8, 8);
  planes.streams[4] = tests::Bytes(200, 0x55);
  const tests::Bytes bytes = planes.bytes();
  const auto map = write("broken.ptm", {bytes.begin(), bytes.end()});
  EXPECT_EQ(described(map)["planes"][4]["compressed_bytes"], 200);
  expect_refused("info --all " + tests::quoted(map), "plane 4 at byte ");
  golden::Image8 image(64, 64, 3);
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    image.samples[i] = static_cast<std::uint8_t>(i * i % 251);
  }
  golden::write_picture(file("a.png"), image);
  std::filesystem::resize_file(file("a.png"), std::filesystem::file_size(file("a.png")) / 2);
  EXPECT_EQ(described(file("a.png"))["width"], 64);
  expect_refused("info --all " + tests::quoted(file("a.png")), "pixels");
}

TEST_F(InfoCommand, TellsTheLevelsOfEveryKindOfSamplesAsTheyAreRead) {
  golden::Image8 image(70, 130, 3);
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    image.samples[i] = static_cast<std::uint8_t>(20 + i * 37 % 200);
  }
  golden::write_picture(file("a.png"), image);
  const golden::ImageReal levels = golden::read_picture(file("a.png"));
  const Json info = described(file("a.png"), "--all");
  for (std::size_t c = 0; c < 3; ++c) {
    double least = 255, greatest = 0, sum = 0;
    for (std::size_t i = c; i < levels.samples.size(); i += 3) {
      least = std::min(least, levels.samples[i]);
      greatest = std::max(greatest, levels.samples[i]);
      sum += levels.samples[i];
    }
    // A level takes two roundings of a double more than read_picture()'s; 70 x 130 sums of them.
    EXPECT_NEAR(info["levels"][c]["min"].get<double>(), least, 1e-12);
    EXPECT_NEAR(info["levels"][c]["max"].get<double>(), greatest, 1e-12);
    EXPECT_NEAR(info["levels"][c]["mean"].get<double>(), sum / (70 * 130), 1e-9);
  }
}

TEST_F(InfoCommand, SaysWhatAFileIsThatItDoesNotRead) {
  const auto says = [&](const std::string& name, const std::string& text, const std::string& what) {
    expect_refused("info " + tests::quoted(write(name, text)), what);
  };
  says("a.rti", "#HSH1.2\n3\n2 2 3\n4 1 1\n",
       "hemispherical harmonics (HSH): 2 x 2 texels, 3 "
       "colours, 4 terms a colour");
  says("b.rti", "#HSH1.2\n3\n2 2 3\n4 1 1\n", "this program reads polynomial texture maps (.ptm)");
  says("info.json", R"({"nplanes": 9, "type": "ptm"})", "Relight");
  says("a.toml", "[map]\nfile = 'x.ptm'\n", "`ptmsim run` and `plan` take a scene");
  says("a.lp", "1\na.png 0 0 1\n", "`ptmsim fit` takes light positions");
  says("a.obj", "v 0 0 0\n", "takes a mesh");
}

}  // namespace
}  // namespace ptm
