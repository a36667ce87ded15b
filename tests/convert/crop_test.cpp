#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "golden/files/picture_file.h"
#include "golden/files/ptm_file.h"
#include "golden/render/light_map.h"
#include "testbench/run/crop_map.h"
#include "tests/files/crafted_ptm.h"
#include "tests/run_program.h"
#include "tests/scratch_folder.h"

namespace ptm::testbench {
namespace {

using golden::MapKind;
using tests::Outcome;

/// A map as files have them: made_map()'s scales show little.
golden::PtmMap noise(MapKind kind) {
  golden::PtmMap map = tests::made_map(kind, 23, 17, 5);
  map.scale = {0.5, -0.25, 1, 0.125, 0.5, 1};
  map.bias = {100, 128, 0, 140, 90, 30};
  return map;
}

struct Row {
  const char* name;
  MapKind kind;
  const char* from;  ///< how the whole is stored
  const char* to;    ///< how the part is
};

class Crop : public testing::TestWithParam<Row> {};

TEST_P(Crop, IsThatPartOfTheWholesPicture) {
  const tests::ScratchFolder folder;
  const auto run = [&](const std::string& arguments) {
    const Outcome outcome = tests::run_program(folder / "log", arguments);
    EXPECT_EQ(outcome.code, 0) << arguments << outcome.err;
  };
  const auto path = [&](const char* name) { return tests::quoted(folder / name); };
  golden::write_ptm(folder / "made.ptm", noise(GetParam().kind));
  run("convert " + path("made.ptm") + " " + path("whole.ptm") + GetParam().from);
  run("convert " + path("whole.ptm") + " " + path("part.ptm") + GetParam().to + " --crop 3,2,7,11");
  for (const char* map : {"whole", "part"}) {
    run("render " + path((std::string(map) + ".ptm").c_str()) + " --light 0.3,-0.6 --out " +
        path((std::string(map) + ".png").c_str()));
  }
  const golden::ImageReal whole = golden::read_picture(folder / "whole.png");
  const golden::ImageReal part = golden::read_picture(folder / "part.png");
  ASSERT_EQ(part.width, 7);
  ASSERT_EQ(part.height, 11);
  for (int y = 0; y < part.height; ++y) {
    for (int x = 0; x < part.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        ASSERT_EQ(part.at(x, y, c), whole.at(3 + x, 2 + y, c)) << x << " " << y << " " << c;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    , Crop,
    testing::Values(Row{"Lrgb", MapKind::lrgb, "", ""}, Row{"Rgb", MapKind::rgb, "", ""},
                    Row{"Lum", MapKind::lum, "", ""},
                    Row{"LrgbInterleaved", MapKind::lrgb, " --version 1.1", " --version 1.1"},
                    Row{"LrgbJpeg", MapKind::lrgb, " --format jpeg", " --format jpeg"},
                    Row{"RgbJpeg", MapKind::rgb, " --format jpeg", " --format jpeg"},
                    Row{"LrgbJpegLs", MapKind::lrgb, " --format jpegls", " --format jpegls"},
                    Row{"RgbJpegLs", MapKind::rgb, " --format jpegls", " --format jpegls"},
                    Row{"JpegToRaw", MapKind::rgb, " --format jpeg", ""}),
    [](const auto& row) { return row.param.name; });

TEST(CropMap, KeepsTheWholeWhereThatIsThePart) {
  for (const MapKind kind : {MapKind::lrgb, MapKind::rgb, MapKind::lum}) {
    const golden::PtmMap map = noise(kind);
    EXPECT_EQ(crop_map(map, {0, 0, 23, 17}, "m"), map);
    EXPECT_EQ(crop_map(crop_map(map, {1, 2, 20, 12}, "m"), {3, 4, 5, 6}, "m"),
              crop_map(map, {4, 6, 5, 6}, "m"));
  }
}

TEST(CropMap, RefusesPartsThatTheMapHasNot) {
  const golden::PtmMap map = noise(MapKind::lrgb);
  constexpr int far = 2147483647;
  for (const golden::Region part : {golden::Region{23, 0, 1, 1},
                                    {0, 17, 1, 1},
                                    {0, 0, 24, 1},
                                    {0, 0, 1, 18},
                                    {22, 16, 2, 1},
                                    {far, far, far, far},
                                    {1, 1, far, far},
                                    {-1, 0, 2, 2},
                                    {0, 0, 0, 1}}) {
    EXPECT_THROW((void)crop_map(map, part, "m"), golden::InputError);
  }
}

TEST(CropMap, IsOneStepAmongTheOthers) {
  const tests::ScratchFolder folder;
  golden::write_ptm(folder / "a.ptm", noise(MapKind::lrgb));
  const std::string command = "convert --json " + tests::quoted(folder / "a.ptm") + " " +
                              tests::quoted(folder / "b.ptm") + " --crop 3,2,7,11";
  const Outcome alone = tests::run_program(folder / "log", command);
  ASSERT_EQ(alone.code, 0) << alone.err;
  const auto report = nlohmann::json::parse(alone.out);
  EXPECT_EQ(report["steps"][0]["step"], "crop");
  EXPECT_FALSE(report.contains("lit")) << "a crop changes no texel";
  const Outcome both = tests::run_program(folder / "log", command + " --kind rgb");
  ASSERT_EQ(both.code, 0) << both.err;
  EXPECT_TRUE(nlohmann::json::parse(both.out).contains("lit"));
  EXPECT_EQ(golden::read_ptm(folder / "b.ptm").map.kind, MapKind::rgb);
  EXPECT_EQ(golden::read_ptm(folder / "b.ptm").map.width, 7);
}

}  // namespace
}  // namespace ptm::testbench
