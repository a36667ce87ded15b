// `ptmsim bump` as a user meets it.
#include <cmath>
#include <nlohmann/json.hpp>

#include "golden/files/ptm_file.h"
#include "golden/render/light_map.h"
#include "testbench/run/hardware_map.h"
#include "tests/run_program.h"
#include "tests/scratch_folder.h"

namespace ptm::tests {
namespace {

golden::Image8 hill(int side) {
  golden::Image8 image(side, side, 1);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double dx = x - side / 2.0, dy = y - side / 2.0;
      image.at(x, y) = static_cast<std::uint8_t>(250 * std::exp(-(dx * dx + dy * dy) / (side * 2)));
    }
  }
  return image;
}

TEST(BumpCommand, MakesOfAHillAMapThatBaseTakesVerbatimAndThatIsBrightTowardsTheLight) {
  const ScratchFolder folder;
  golden::write_picture(folder / "h.png", hill(40));
  const Outcome outcome =
      run_program(folder / "log",
                  "bump " + quoted(folder / "h.png") + " --json --out " + quoted(folder / "m.ptm"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["from"], "height");
  EXPECT_EQ(json["domain"], "hemisphere");
  EXPECT_NEAR(json["stored"]["rmse"].get<double>(), json["real"]["rmse"].get<double>(), 0.5);
  const golden::PtmMap map = golden::read_ptm(folder / "m.ptm").map;
  EXPECT_EQ(testbench::store_map(map, reference::kBase).origin, quantize::Origin::verbatim);
  const golden::ImageReal lit = golden::light_map(map, 0, 0.7);  // from above
  EXPECT_GT(lit.at(20, 15), lit.at(20, 25) + 50);                // row 15 faces up
  EXPECT_NEAR(lit.at(15, 20), lit.at(25, 20), 20);
}

TEST(BumpCommand, TakesANormalMapAndAStrength) {
  const ScratchFolder folder;
  golden::Image8 normals(8, 8, 3);
  for (std::size_t i = 0; i < normals.samples.size(); i += 3) {
    normals.samples[i] = 160;
    normals.samples[i + 1] = 128;
    normals.samples[i + 2] = 250;
  }
  golden::write_picture(folder / "n.png", normals);
  const auto lit = [&](const std::string& more) {
    const Outcome outcome =
        run_program(folder / "log", "bump " + quoted(folder / "n.png") + " --normals --out " +
                                        quoted(folder / "m.ptm") + more);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return golden::light_map(golden::read_ptm(folder / "m.ptm").map, -0.8, 0).at(3, 3);
  };
  EXPECT_GT(lit(""), lit(" --strength 3") + 50);  // leaning further right, away from the light
}

TEST(BumpCommand, TakesANormalMapWithABlackBackgroundAndWithGreenDown) {
  const ScratchFolder folder;
  golden::Image8 normals(24, 24, 3);
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 24; ++x) {
      const double u = (x - 12) / 20.0, down = (y - 12) / 20.0, r = u * u + down * down;
      if (r > 0.3) continue;  // a ball before black
      const double parts[] = {u, down, std::sqrt(1 - r)};
      for (int c = 0; c < 3; ++c) {
        normals.at(x, y, c) = static_cast<std::uint8_t>(std::lround(127.5 * (1 + parts[c])));
      }
    }
  }
  golden::write_picture(folder / "n.png", normals);
  const auto lit_from_above = [&](const std::string& more, bool says_green) {
    const Outcome outcome =
        run_program(folder / "log", "bump " + quoted(folder / "n.png") + " --normals" + more +
                                        " --out " + quoted(folder / "m.ptm"));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("texels are background without a normal"), std::string::npos);
    EXPECT_EQ(outcome.out.find("as if green ran") != std::string::npos, says_green) << outcome.out;
    return golden::light_map(golden::read_ptm(folder / "m.ptm").map, 0, 0.7);
  };
  const golden::ImageReal down = lit_from_above(" --green-down", false);
  EXPECT_GT(down.at(12, 6), down.at(12, 18) + 50);  // the upper half faces up
  const golden::ImageReal up = lit_from_above("", true);
  EXPECT_LT(up.at(12, 6), up.at(12, 18) - 50);
  EXPECT_EQ(run_program(folder / "log", "bump " + quoted(folder / "n.png") +
                                            " --green-down --out " + quoted(folder / "m.ptm"))
                .code,
            2);
}

TEST(BumpCommand, RefusesBadPicturesWithCode3AndBadUsageWithCode2) {
  const ScratchFolder folder;
  golden::write_picture(folder / "h.png", hill(8));
  const std::string out = " --out " + quoted(folder / "m.ptm");
  for (const std::string& bad : {quoted(folder / "none.png"), quoted(folder.write("t.png", "text")),
                                 quoted(folder / "h.png") + " --normals"}) {
    const Outcome outcome = run_program(folder / "log", "bump " + bad + out);
    EXPECT_EQ(outcome.code, 3) << bad << outcome.err;
    EXPECT_NE(outcome.err.find("expected"), std::string::npos) << outcome.err;
  }
  const std::string in = quoted(folder / "h.png");
  for (const std::string& bad :
       {std::string("bump"), "bump " + in, "bump " + in + out + " --preset none",
        "bump " + in + out + " --domain ring", "bump " + in + out + " --height --normals",
        "bump " + in + out + " --strength nan"}) {
    EXPECT_EQ(run_program(folder / "log", bad).code, 2) << bad;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "m.ptm"));
}

}  // namespace
}  // namespace ptm::tests
