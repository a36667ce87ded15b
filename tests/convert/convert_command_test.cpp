// The steps of `ptmsim convert`, and what `ptmsim info` says of presets, as a user meets them.
#include <array>
#include <nlohmann/json.hpp>

#include "golden/files/ptm_file.h"
#include "tests/convert/made_maps.h"
#include "tests/run_program.h"
#include "tests/scratch_folder.h"

namespace ptm::tests {
namespace {

using golden::MapKind;
using Json = nlohmann::json;

class ConvertCommand : public testing::Test {
 protected:
  Outcome convert(const std::string& options, const golden::PtmMap& map) {
    golden::write_ptm(folder / "in.ptm", map);
    return run_program(folder / "log", "convert " + quoted(folder / "in.ptm") + " " +
                                           quoted(folder / "out.ptm") + " " + options);
  }
  Json json(const std::string& options, const golden::PtmMap& map) {
    const Outcome outcome = convert("--json " + options, map);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
  ScratchFolder folder;
};

TEST_F(ConvertCommand, MakesAnRgbMapAndSaysWhatItChanged) {
  const Json report = json("--kind rgb", smooth_map(MapKind::lrgb, 20, 10));
  EXPECT_EQ(report["format"], "PTM_FORMAT_RGB");
  EXPECT_EQ(report["steps"][0]["step"], "rgb");
  EXPECT_GT(report["lit"]["psnr_db"], 50);
  EXPECT_EQ(golden::read_ptm(folder / "out.ptm").map.kind, MapKind::rgb);
  const Outcome text = convert("--kind rgb", smooth_map(MapKind::lum, 20, 10));
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("what the steps changed under 24 lights: "), std::string::npos);
}

TEST_F(ConvertCommand, WritesMipLevelsUnderNumbersDownToOneTexel) {
  const Json report = json("--mip", smooth_map(MapKind::lrgb, 21, 6));
  ASSERT_EQ(report["levels"].size(), 5U);
  const int widths[] = {21, 10, 5, 2, 1}, heights[] = {6, 3, 1, 1, 1};
  for (std::size_t level = 0; level < 5; ++level) {
    const auto map = golden::read_ptm(folder / ("out." + std::to_string(level) + ".ptm")).map;
    EXPECT_EQ(map.width, widths[level]);
    EXPECT_EQ(map.height, heights[level]);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "out.ptm"));
}

TEST_F(ConvertCommand, MakesAPaletteThatTheSeedDecides) {
  const golden::PtmMap map = smooth_map(MapKind::lrgb, 30, 30);
  const Json report = json("--palette 16 --seed 5", map);
  EXPECT_NE(report["steps"][0]["how"].get<std::string>().find("a palette of 16 entries"),
            std::string::npos);
  EXPECT_LT(report["lit"]["psnr_db"], 60);
  const golden::PtmMap first = golden::read_ptm(folder / "out.ptm").map;
  (void)json("--palette 16 --seed 5", map);
  EXPECT_EQ(golden::read_ptm(folder / "out.ptm").map, first);
  (void)json("--palette 16 --seed 6", map);
  EXPECT_NE(golden::read_ptm(folder / "out.ptm").map, first);
}

TEST_F(ConvertCommand, ToleratesLossInJpegLsAndMeasuresItOnThePicture) {
  const golden::PtmMap map = smooth_map(MapKind::lrgb, 50, 40);
  const Json none = json("--format jpegls", map), two = json("--format jpegls --near 2", map);
  EXPECT_FALSE(none.contains("coding_lit"));
  EXPECT_EQ(none["coefficients"]["max"], 0);
  EXPECT_EQ(two["coefficients"]["max"], 2);
  EXPECT_GT(two["coding_lit"]["max"], 0);
  EXPECT_LT(two["payload_bits_per_texel"], none["payload_bits_per_texel"].get<double>() - 5);
}

TEST_F(ConvertCommand, HoldsAMapForAPresetWithDither) {
  golden::PtmMap map = smooth_map(MapKind::lrgb, 32, 32);
  map.scale.fill(0.9);
  const Json report = json("--preset paper8 --dither diffused", map);
  EXPECT_EQ(report["steps"][0]["step"], "hold");
  const auto dithered = golden::read_ptm(folder / "out.ptm").map;
  (void)json("--preset paper8", map);
  EXPECT_NE(golden::read_ptm(folder / "out.ptm").map, dithered);
}

TEST_F(ConvertCommand, RefusesOptionsThatDoNotGoTogetherAndWritesNothing) {
  for (const char* bad :
       {"--near 1", "--format jpeg --near 1", "--mip --palette 4", "--palette 1",
        "--near 128 --format jpegls", "--kind lum", "--dither blue", "--preset none"}) {
    EXPECT_EQ(convert(bad, smooth_map(MapKind::lrgb, 4, 4)).code, 2) << bad;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "out.ptm"));
}

constexpr std::array kStepsThatQuantise{"--palette 8", "--kind rgb", "--mip",
                                        "--preset paper8 --dither diffused"};

TEST_F(ConvertCommand, EndsWithAMapHoweverSmallItsScalesAre) {
  for (const MapKind kind : {MapKind::lrgb, MapKind::rgb}) {
    golden::PtmMap map = smooth_map(kind, 12, 9);
    map.scale = {1e-300, -1e-300, 1e-308, 0.5, -1, 1e-9};
    for (const char* steps : kStepsThatQuantise) {
      const Outcome outcome = convert(steps, map);
      EXPECT_EQ(outcome.code, 0) << steps << outcome.err;
    }
  }
}

TEST_F(ConvertCommand, RefusesScalesWhoseCoefficientsTheHardwareCannotHold) {
  for (const double scale : {1e12, -1e100, 1e300}) {
    golden::PtmMap map = smooth_map(MapKind::lrgb, 12, 9);
    map.scale[3] = scale;
    for (const char* steps : kStepsThatQuantise) {
      std::filesystem::remove(folder / "out.ptm");
      const Outcome outcome = convert(steps, map);
      EXPECT_EQ(outcome.code, 3) << steps << ' ' << scale;
      EXPECT_NE(outcome.err.find("not in the hardware's range"), std::string::npos) << outcome.err;
      EXPECT_FALSE(std::filesystem::exists(folder / "out.ptm")) << steps;
    }
  }
}

TEST_F(ConvertCommand, InfoTellsWhichPresetTakesTheMapVerbatimAndWhyOthersDoNot) {
  golden::PtmMap map = smooth_map(MapKind::lrgb, 8, 8);
  map.coef[0] = 0;  // 150 below its bias, within nine bits and not within eight
  golden::write_ptm(folder / "in.ptm", map);
  const Outcome outcome = run_program(folder / "log", "info --all --json " + quoted(folder / "in.ptm"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json rows = Json::parse(outcome.out)["presets"];
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0]["preset"], "paper8");
  EXPECT_FALSE(rows[0]["verbatim"].get<bool>());
  EXPECT_NE(rows[0]["why_not"].get<std::string>().find("delta_bits = 8"), std::string::npos);
  EXPECT_TRUE(rows[1]["verbatim"].get<bool>());
  EXPECT_EQ(rows[1]["luminance_beyond"], 0);
}

TEST_F(ConvertCommand, InfoBoundsTheErrorOfMapsThatAPresetHoldsAsTheyAre) {
  // Flat texels: a5 = 100 under any light, colour 255. No bit of it is dropped before D7.
  golden::PtmMap map = smooth_map(MapKind::lrgb, 2, 1);
  map.scale.fill(1);
  map.bias.fill(0);
  std::fill(map.coef.begin(), map.coef.end(), std::uint8_t{0});
  std::fill(map.color.begin(), map.color.end(), std::uint8_t{255});
  map.coef[5] = map.coef[11] = 100;
  const auto bounds = [&] {
    golden::write_ptm(folder / "in.ptm", map);
    const Outcome outcome = run_program(folder / "log", "info --all --json " + quoted(folder / "in.ptm"));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::vector<Json> column;
    const Json rows = Json::parse(outcome.out)["presets"];
    for (const Json& row : rows) {
      column.push_back(row["levels_off_at_most"]);
    }
    return column;
  };
  // paper8 truncates: a level in D7. base: D6 to whole levels and D7, half each. wide: D6 to 16ths.
  EXPECT_EQ(bounds(), (std::vector<Json>{1.0, 1.0, 0.5 / 16 + 0.5 + 0.5 / 255}));
  // 640 and a slope of 384.7: beyond ten bits at one place of the rim, which a sample of lights
  // may miss.
  map.scale.fill(16);
  map.coef[5] = map.coef[11] = 40;
  map.coef[3] = 23;
  map.coef[4] = 7;
  EXPECT_EQ(bounds(), (std::vector<Json>{nullptr, nullptr, nullptr}));
  map.coef[4] = 6;  // 380.3: within
  EXPECT_TRUE(bounds()[1].is_number());
}

}  // namespace
}  // namespace ptm::tests
