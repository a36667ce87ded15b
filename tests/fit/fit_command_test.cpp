// The commands synthesize and fit, run as a user runs them.
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <iterator>
#include <nlohmann/json.hpp>

#include "golden/files/ptm_file.h"
#include "testbench/run/stored_texture.h"
#include "tests/fit/scratch_folder.h"
#include "tests/shared_data.h"

namespace ptm::testbench {
namespace {

using tests::ScratchFolder;

struct Outcome {
  int code = -1;
  std::string out, err;
};

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string quoted(const std::filesystem::path& path) {
  std::string text(1, '\'');
  text.append(path.string()).push_back('\'');
  return text;
}

Outcome run(const ScratchFolder& folder, const std::string& arguments) {
  const auto out = folder / "stdout.txt", err = folder / "stderr.txt";
  std::string command = quoted(PTM_PROGRAM);
  command.append(" ").append(arguments);
  command.append(" >").append(quoted(out)).append(" 2>").append(quoted(err));
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
}

TEST(FitCommand, MakesAMapOfASynthesizedCaptureThatTheHardwareTakesVerbatim) {
  const ScratchFolder folder;
  const Outcome made =
      run(folder, "synthesize --size 64 --lights 20 --out " + quoted(folder / "capture"));
  ASSERT_EQ(made.code, 0) << made.err;
  const Outcome fitted = run(folder, "fit " + quoted(folder / "capture/capture.lp") +
                                         " --json --out " + quoted(folder / "map.ptm"));
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
  const StoredTexture texture =
      store_texture(map, reference::kBase, quantize::Method::nearest_plane);
  EXPECT_EQ(texture.why_not_verbatim, "");
  EXPECT_EQ(nlohmann::json(texture.map.shift), json.at("shift"));
  EXPECT_EQ(nlohmann::json(texture.map.bias), json.at("bias"));
}

TEST(FitCommand, NearestPlaneBeatsPlainAgainstTheRealFit) {
  const ScratchFolder folder;
  ASSERT_EQ(run(folder, "synthesize --size 64 --lights 20 --out " + quoted(folder / "c")).code, 0);
  double rms[2] = {};
  for (const int nearest : {0, 1}) {
    const Outcome fitted = run(folder, "fit " + quoted(folder / "c/capture.lp") + " --json --out " +
                                           quoted(folder / "map.ptm") + " --method " +
                                           (nearest == 1 ? "nearest_plane" : "plain"));
    ASSERT_EQ(fitted.code, 0) << fitted.err;
    rms[nearest] = nlohmann::json::parse(fitted.out).at("quantization_rms");
  }
  EXPECT_LT(rms[1], 0.9 * rms[0]);
}

TEST(FitCommand, SaysSoWhenTheLightsLeaveThePolynomialOpen) {
  const ScratchFolder folder;
  folder.picture("a.png");
  folder.picture("b.png", 4, 3, 50);
  const auto lp = folder.write("c.lp", "a.png 0 0 1\nb.png 0.6 0 0.8\n");
  const Outcome fitted = run(folder, "fit " + quoted(lp) + " --out " + quoted(folder / "m.ptm"));
  EXPECT_EQ(fitted.code, 0) << fitted.err;
  EXPECT_NE(fitted.out.find("the 2 lights determine 2 of 6 coefficients"), std::string::npos);
}

TEST(FitCommand, EndsWithCode3AndWritesNothingOnBadInput) {
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
    const Outcome outcome = run(folder, "fit " + quoted(lp) + " --out " + quoted(folder / "m.ptm"));
    EXPECT_EQ(outcome.code, 3) << text;
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "m.ptm"));
  }
  const auto lp = folder.write("c.lp", "a.png 0 0 1\n");
  EXPECT_EQ(run(folder, "fit " + quoted(lp) + " --out " + quoted(folder / "none/m.ptm")).code, 3);
  EXPECT_EQ(run(folder, "fit " + quoted(folder / "none.lp") + " --out x.ptm").code, 3);
}

TEST(FitCommand, EndsWithCode2OnWrongUsage) {
  const ScratchFolder folder;
  for (const char* arguments : {"fit", "fit a.lp", "fit a.lp --out m.ptm --preset none",
                                "fit a.lp --out m.ptm --method best", "synthesize",
                                "synthesize --out x --size 3", "synthesize --out x --lights 0"}) {
    EXPECT_EQ(run(folder, arguments).code, 2) << arguments;
  }
}

TEST(FitCommand, LosesLessThanATenthOfADecibelToStorageOnRealCaptures) {
  const ScratchFolder folder;
  for (const char* name : {"icon/dirs.lp", "dome/Dome/dirs.lp"}) {
    PTM_SHARED_DATA_OR_SKIP(lp, name);
    const Outcome fitted =
        run(folder, "fit " + quoted(lp) + " --json --out " + quoted(folder / "map.ptm"));
    ASSERT_EQ(fitted.code, 0) << fitted.err;
    const auto json = nlohmann::json::parse(fitted.out);
    EXPECT_NEAR(json.at("stored_fit").at("psnr_db").get<double>(),
                json.at("real_fit").at("psnr_db").get<double>(), 0.1)
        << name;
  }
}

TEST(SynthesizeCommand, RefusesAFolderThatIsAFile) {
  const ScratchFolder folder;
  const auto file = folder.write("taken", "text");
  const Outcome outcome = run(folder, "synthesize --out " + quoted(file));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("taken"), std::string::npos);
}

}  // namespace
}  // namespace ptm::testbench
