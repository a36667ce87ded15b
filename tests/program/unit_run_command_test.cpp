#include <nlohmann/json.hpp>
#include <optional>

#include "golden/files/picture_file.h"
#include "tests/run_program.h"

namespace ptm {
namespace {

using nlohmann::json;

const std::string kImage = "[image]\nsize = [20, 12]\n";
const std::string kMap = "[[texture]]\nname = \"m\"\ngenerate = \"relief\"\nsize = [16, 16]\n";
const std::string kPlane = "[[object]]\nkind = \"plane\"\ntexture = \"m\"\n";
const std::string kLight = "[[light]]\ndirection = [0, -3, 4]\n";
const std::string kUnbuilt = "[hardware]\ntmus = 2\ncache_kib = 4\n";

/// A variable of the environment for as long as this stands.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~Environment() {
    if (before_) {
      setenv(name_, before_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

/// Scenes with [[object]] through the program.
class UnitRunCommand : public tests::Program {
 protected:
  std::string scene(const std::string& text) const {
    return tests::quoted(write("scene.toml", text));
  }
  std::string out() const { return " --out " + tests::quoted(file("report")); }
  json report() const { return json::parse(tests::text_of(file("report") / "report.json")); }
  /// The scene is there before, so that a refused run is seen to add nothing.
  void refused(const std::string& text, const std::string& says) const {
    const std::string path = scene(text);
    expect_refused("run " + path + out(), says);
  }
  void run_and_agree(const std::string& text, std::size_t frames) const {
    const tests::Outcome outcome = run("run " + scene(text) + out());
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json found = report();
    EXPECT_TRUE(found.at("agree"));
    EXPECT_EQ(found.at("unit").at("late_pixels"), 0);
    EXPECT_EQ(found.at("unit").at("differing_counters"), json::array());
    EXPECT_EQ(found.at("scene").at("lights").size(), frames);
    EXPECT_EQ(found.at("models").at("rtl").at("pictures").size(), frames);
  }
  std::uint64_t counter(const std::string& model, const std::string& name) const {
    return report().at("unit").at("timings").at(model).at("counters").at(name);
  }
};

TEST_F(UnitRunCommand, SaysWhichFacesOfAMeshAreLeftOut) {
  write("m.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvt 0 0\nf 1 2\nf 1/1 2/1 3/1\n");
  const tests::Outcome outcome =
      run("run " +
          scene(kImage + kMap + kLight +
                "[[object]]\nkind = \"mesh\"\nfile = \"m.obj\"\ntexture = \"m\"\n" + kUnbuilt) +
          out() + " --models golden");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("note: m.obj: 1 face of fewer than three corners left out, the first "
                             "in line 5"),
            std::string::npos)
      << outcome.out;
}

TEST_F(UnitRunCommand, RefusesAFileThatIsNotThereNamingIt) {
  const std::string from = "[[texture]]\nname = \"m\"\n";
  for (const std::string source : {"ptm = \"absent.ptm\"", "capture = \"absent.lp\"",
                                   "bump = \"absent.png\"", "ptm = \"scene.toml\""}) {
    const std::string name = source.substr(source.find('"') + 1);
    refused(from + source + "\n" + kPlane + kLight, name.substr(0, name.size() - 1) + ": ");
  }
  refused(from + "picture = \"absent.png\"\n[[object]]\nkind = \"plane\"\ncolor = \"m\"\n" + kLight,
          "absent.png: ");
  refused(kMap + "[[object]]\nkind = \"mesh\"\nfile = \"absent.obj\"\ntexture = \"m\"\n" + kLight,
          "absent.obj: ");
}

TEST_F(UnitRunCommand, RefusesAMeshWithAFaultNamingItsLine) {
  write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  refused(kMap + "[[object]]\nkind = \"mesh\"\nfile = \"bad.obj\"\ntexture = \"m\"\n" + kLight,
          "bad.obj: line 4: found \"4\", expected an index of one of the 3 v so far");
}

TEST_F(UnitRunCommand, RefusesATextureThatTheUnitCannotAddress) {
  golden::write_picture(file("wide.png"), golden::Image8(4097, 1, 3));
  refused(
      "[[texture]]\nname = \"m\"\npicture = \"wide.png\"\n[[object]]\nkind = \"plane\"\n"
      "color = \"m\"\n" +
          kLight,
      "wide.png: size of texture 'm': found 4097 x 1 texels, expected at most 4096 a side");
  refused("[[texture]]\nname = \"m\"\nbump = \"wide.png\"\n" + kPlane + kLight,
          "wide.png: size of texture 'm': found 4097 x 1 texels, expected at most 4096 a side");
}

TEST_F(UnitRunCommand, RefusesALightThatThePresetCannotExpressNamingIt) {
  const std::string text = kImage + kMap + kPlane + "[[light]]\ndirection = [1.9, 0]\n";
  refused(text + "[hardware]\npreset = \"paper8\"\n",
          "line 11 (light[0].direction): found light (1.9, 0), expected coordinates of at most 1,");
  ASSERT_EQ(run("run " + scene(text) + out()).code, 0) << "base has two integer bits";
  const json presets = report().at("presets");
  ASSERT_EQ(presets.size(), 2U) << "paper8 is left out of the table";
  EXPECT_NE(report().dump().find("preset paper8 is left out of the table"), std::string::npos);
}

TEST_F(UnitRunCommand, BuildsRtlThatDoesNotComeWithTheBuildOnceAndKeepsIt) {
  const Environment cache("PTMSIM_CACHE", file("cache").string());
  const std::string path = scene(kImage + kMap + kPlane + kLight + kUnbuilt);
  const auto first = run("run " + path + out() + " --models reference,pipeline,rtl");
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_NE(first.err.find("building an RTL unit, once: CoefBits=8 "), std::string::npos);
  EXPECT_EQ(report().at("unit").at("late_pixels"), 0);
  EXPECT_GT(counter("rtl", "cycles"), 0U);
  const auto second = run("run " + path + out() + " --models reference,pipeline,rtl");
  ASSERT_EQ(second.code, 0) << second.err;
  EXPECT_EQ(second.err, "");
}

TEST_F(UnitRunCommand, NamesThePackageOfAToolThatIsNeededToBuildRtl) {
  const Environment cache("PTMSIM_CACHE", file("cache").string());
  const Environment path("PATH", file("").string());
  const auto outcome = run("run " + scene(kImage + kMap + kPlane + kLight + kUnbuilt) + out());
  EXPECT_EQ(outcome.code, 4);
  EXPECT_NE(outcome.err.find("cmake is needed: install the package cmake"), std::string::npos)
      << outcome.err;
}

TEST_F(UnitRunCommand, DrawsHardwareThatIsNotBuiltAsRtlWithTheOtherModels) {
  const std::string path = scene(kImage + kMap + kPlane + kLight + kUnbuilt);
  const auto outcome = run("run " + path + out() + " --models golden,reference,pipeline");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(report().at("models").size(), 3U);
  EXPECT_EQ(report().at("config").at("unit").at("cache_kib"), 4);
  EXPECT_EQ(report().at("unit").at("timings").size(), 2U) << "pipeline and loose";
  EXPECT_GT(counter("pipeline", "cycles"), 0U);
}

TEST_F(UnitRunCommand, RefusesPalettesThatTheUnitHasNoRoomFor) {
  refused(kMap + "palette = 257\n" + kPlane + kLight,
          "line 1 (texture[0]): found a palette of 257 entries, expected at most 256 for an LRGB");
  refused(kMap + "palette = 4097\n" + kPlane + kLight,
          "line 5 (texture[0].palette): found 4097, expected an integer from 2 to 4096");
  refused(kMap + "palette = 1\n" + kPlane + kLight,
          "line 5 (texture[0].palette): found 1, expected an integer from 2 to 4096");
  std::string five, objects;
  for (const std::string name : {"a", "b", "c", "d"}) {
    five += "[[texture]]\nname = \"" + name +
            "\"\ngenerate = \"noise\"\nsize = [4, 4]\nkind = \"rgb\"\npalette = 4\n";
    objects += "[[object]]\nkind = \"plane\"\ntexture = \"" + name + "\"\n";
  }
  refused(five + objects + kLight,
          "line 7 (texture[1]): found a second RGB palette, expected at most one");
}

TEST_F(UnitRunCommand, RefusesAPictureThatIsTooLarge) {
  refused("[image]\nsize = [16385, 4]\n" + kMap + kPlane + kLight,
          "line 2 (image.size): found 16385, expected an integer from 1 to 16384");
  refused("[image]\nsize = [16384, 16384]\n" + kMap + kPlane + kLight,
          "line 2 (image.size): found 16384 x 16384, expected at most 16777216 pixels");
}

TEST_F(UnitRunCommand, RefusesUnknownKeysAndWhatIsNoNumber) {
  refused("colour = 3\n" + kMap + kPlane + kLight, "line 1: found unknown key 'colour'");
  refused(kMap + kPlane + kLight + "[hardware]\ncolour = 3\n", "unknown key 'hardware.colour'");
  refused(kMap + kPlane + "[[light]]\ndirection = [nan, 0]\n",
          "line 9 (light[0].direction[0]): found nan, expected a finite number");
  refused(kMap + kPlane + kLight + "[camera]\nposition = [inf, 0, 1]\n",
          "line 11 (camera.position[0]): found inf, expected a finite number");
  refused(kMap + kPlane + "[[light]]\nposition = [0, 0, nan]\n", "(light[0].position[2])");
}

TEST_F(UnitRunCommand, DrawsTheBackgroundAndSaysSoWhereTheCameraSeesNothing) {
  const std::string away = "[camera]\ntarget = [0, -8, 0]\n";
  run_and_agree(kImage + "background = [10, 20, 30]\n" + away + kMap + kPlane + kLight + kLight, 2);
  EXPECT_NE(report().at("notes").dump().find("the camera sees no object"), std::string::npos);
  for (const char* model : {"pipeline", "loose", "rtl"}) {
    EXPECT_EQ(counter(model, "cycles"), 0U) << model;
    EXPECT_EQ(counter(model, "pixels"), 0U) << model;
  }
  const golden::ImageReal picture = golden::read_picture(file("report") / "rtl_01.png");
  for (std::size_t i = 0; i < picture.samples.size(); ++i) {
    ASSERT_EQ(picture.samples[i], 10.0 * static_cast<double>(i % 3 + 1));
  }
}

TEST_F(UnitRunCommand, KeepsTheCacheFromLightToLightOnlyIfAsked) {
  const std::string rest = kImage + kMap + kPlane + kLight + kLight + kLight;
  run_and_agree(rest, 3);
  const std::uint64_t cold = counter("rtl", "lines_read");
  run_and_agree("keep_cache = true\n" + rest, 3);
  EXPECT_EQ(3 * counter("rtl", "lines_read"), cold) << "only the first frame reads";
  EXPECT_EQ(counter("loose", "lines_read"), counter("rtl", "lines_read"));
}

TEST_F(UnitRunCommand, CountsOnlyTheSecondOfFramesDrawnTwice) {
  const std::string rest = kImage + kMap + kPlane + kLight + kLight;
  run_and_agree("draw_twice = true\n" + rest, 2);
  EXPECT_EQ(counter("rtl", "lines_read"), 0U);
  EXPECT_EQ(counter("rtl", "tag_misses"), 0U);
  EXPECT_EQ(counter("loose", "lines_read"), 0U);
  EXPECT_EQ(counter("rtl", "pixels"), counter("loose", "pixels"));
  run_and_agree("draw_twice = true\nkeep_cache = true\n" + rest, 2);
  EXPECT_EQ(counter("rtl", "lines_read"), 0U);
}

TEST_F(UnitRunCommand, ReportsEachLightAsTheSceneSaysIt) {
  run_and_agree(kImage + kMap + kPlane + kLight + "[[light]]\ndirection = [-0.5, 0.25]\n" +
                    "[[light]]\nposition = [1, -2, 3]\n",
                3);
  const json lights = report().at("scene").at("lights");
  EXPECT_NEAR(lights[0].at("direction")[1].get<double>(), -0.6, 1e-15);
  EXPECT_EQ(lights[1], json({-0.5, 0.25}));
  EXPECT_EQ(lights[2].at("position"), json({1.0, -2.0, 3.0}));
}

}  // namespace
}  // namespace ptm
