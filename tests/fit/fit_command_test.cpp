// The commands synthesize and fit, run as a user runs them.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "golden/files/ptm_file.h"
#include "testbench/run/hardware_map.h"
#include "tests/run_program.h"
#include "tests/scratch_folder.h"

namespace ptm::testbench {
namespace {

using tests::ScratchFolder;

using tests::Outcome;
using tests::quoted;

class FitCommand : public tests::Program {};
class SynthesizeCommand : public tests::Program {};

TEST_F(FitCommand, MakesAMapOfASynthesizedCaptureThatTheHardwareTakesVerbatim) {
  const ScratchFolder folder;
  const Outcome made = run("synthesize --size 64 --lights 20 --out " + quoted(folder / "capture"));
  ASSERT_EQ(made.code, 0) << made.err;
  const Outcome fitted = run("fit " + quoted(folder / "capture/capture.lp") + " --json --out " +
                             quoted(folder / "map.ptm"));
  ASSERT_EQ(fitted.code, 0) << fitted.err;
  const auto json = nlohmann::json::parse(fitted.out);
  EXPECT_EQ(json.at("photographs"), 20);
  EXPECT_EQ(json.at("rank"), 6);
  EXPECT_TRUE(json.at("notes").empty()) << json.at("notes");
  const double real = json.at("real_fit").at("psnr_db"),
               stored = json.at("stored_fit").at("psnr_db");
  EXPECT_GT(stored, 18);  // a polynomial cannot follow cast shadows; much less is a wrong picture
  EXPECT_NEAR(stored, real, 0.1);
  const golden::PtmMap map = golden::read_ptm(folder / "map.ptm").map;
  const HardwareMap hardware = store_map(map, reference::kBase);
  EXPECT_EQ(hardware.origin, quantize::Origin::verbatim) << hardware.how;
  EXPECT_EQ(nlohmann::json(hardware.texture.shift), json.at("shift"));
  EXPECT_EQ(nlohmann::json(hardware.texture.bias), json.at("bias"));
}

TEST_F(FitCommand, NearestPlaneBeatsPlainAgainstTheRealFit) {
  const ScratchFolder folder;
  ASSERT_EQ(run("synthesize --size 64 --lights 20 --out " + quoted(folder / "c")).code, 0);
  double rms[2] = {};
  for (const int nearest : {0, 1}) {
    const Outcome fitted =
        run("fit " + quoted(folder / "c/capture.lp") + " --json --out " +
            quoted(folder / "map.ptm") + " --method " + (nearest == 1 ? "nearest_plane" : "plain"));
    ASSERT_EQ(fitted.code, 0) << fitted.err;
    rms[nearest] = nlohmann::json::parse(fitted.out).at("quantization_rms");
  }
  EXPECT_LT(rms[1], 0.9 * rms[0]);
}

TEST_F(FitCommand, FillsTheRangeOfColourUnlessAskedForThatOfLuminance) {
  const ScratchFolder folder;
  ASSERT_EQ(run("synthesize --size 32 --lights 20 --out " + quoted(folder / "c")).code, 0);
  const std::string fit =
      "fit " + quoted(folder / "c/capture.lp") + " --out " + quoted(folder / "map.ptm");
  const auto share_of_full_colours = [&](const std::string& options) {
    const Outcome fitted = run(fit + options);
    EXPECT_EQ(fitted.code, 0) << fitted.err;
    const golden::PtmMap map = golden::read_ptm(folder / "map.ptm").map;
    std::size_t full = 0;
    for (std::size_t t = 0; t < map.texels(); ++t) {
      full += std::max({map.color[t * 3], map.color[t * 3 + 1], map.color[t * 3 + 2]}) == 255;
    }
    return static_cast<double>(full) / static_cast<double>(map.texels());
  };
  EXPECT_EQ(share_of_full_colours(""), 1);
  EXPECT_EQ(share_of_full_colours(" --full-range color"), 1);
  EXPECT_LT(share_of_full_colours(" --full-range luminance"), 0.5);
  EXPECT_LT(share_of_full_colours(" --quantizer hp"), 0.5);
}

TEST_F(FitCommand, RefusesFullColourInHpsRecipe) {
  const ScratchFolder folder;
  ASSERT_EQ(run("synthesize --size 16 --lights 8 --out " + quoted(folder / "c")).code, 0);
  const Outcome fitted = run("fit " + quoted(folder / "c/capture.lp") + " --out " +
                             quoted(folder / "map.ptm") + " --quantizer hp --full-range color");
  EXPECT_EQ(fitted.code, 2);
  EXPECT_NE(fitted.err.find("--full-range color and --quantizer hp"), std::string::npos)
      << fitted.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "map.ptm"));
}

TEST_F(FitCommand, SaysSoWhenTheLightsLeaveThePolynomialOpen) {
  const ScratchFolder folder;
  folder.picture("a.png");
  folder.picture("b.png", 4, 3, 50);
  const auto lp = folder.write("c.lp", "a.png 0 0 1\nb.png 0.6 0 0.8\n");
  const Outcome fitted = run("fit " + quoted(lp) + " --out " + quoted(folder / "m.ptm"));
  EXPECT_EQ(fitted.code, 0) << fitted.err;
  EXPECT_NE(fitted.out.find("the 2 lights determine 2 of 6 coefficients"), std::string::npos);
}

TEST_F(FitCommand, EndsWithCode3AndWritesNothingOnBadInput) {
  const ScratchFolder folder;
  folder.picture("a.png", 4, 3);
  folder.picture("b.png", 5, 3);
  folder.write("no.png", "text");
  const std::pair<std::string, std::string> cases[] = {
      {"a.png 0 0 1\nb.png 0.6 0 0.8\n", "line 2"},
      {"a.png 0 0 1\nno.png 0.6 0 0.8\n", "no.png"},
      {"a.png 0 0 1\ngone.png 0.6 0 0.8\n", "line 2: found no picture 'gone.png'"},
      {"a.png 0 0 0\n", "line 1: found light (0, 0, 0)"},
      {"a.png 0 0 nan\n", "line 1"},
      {"", "no light"},
  };
  for (const auto& [text, message] : cases) {
    const auto lp = folder.write("c.lp", text);
    const Outcome outcome = run("fit " + quoted(lp) + " --out " + quoted(folder / "m.ptm"));
    EXPECT_EQ(outcome.code, 3) << text;
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "m.ptm"));
  }
  const auto lp = folder.write("c.lp", "a.png 0 0 1\n");
  EXPECT_EQ(run("fit " + quoted(lp) + " --out " + quoted(folder / "none/m.ptm")).code, 3);
  EXPECT_EQ(run("fit " + quoted(folder / "none.lp") + " --out x.ptm").code, 3);
}

TEST_F(FitCommand, EndsWithCode2OnWrongUsage) {
  for (const char* arguments : {"fit", "fit a.lp", "fit a.lp --out m.ptm --preset none",
                                "fit a.lp --out m.ptm --method best", "synthesize",
                                "synthesize --out x --size 3", "synthesize --out x --lights 0"}) {
    EXPECT_EQ(run(arguments).code, 2) << arguments;
  }
}

TEST_F(SynthesizeCommand, RefusesAFolderThatIsAFile) {
  const ScratchFolder folder;
  const auto file = folder.write("taken", "text");
  const Outcome outcome = run("synthesize --out " + quoted(file));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("taken"), std::string::npos);
}

}  // namespace
}  // namespace ptm::testbench
