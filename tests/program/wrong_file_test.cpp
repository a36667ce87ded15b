#include "golden/files/picture_file.h"
#include "tests/files/crafted_ptm.h"
#include "tests/program/small_map.h"
#include "tests/run_measured.h"
#include "tests/run_program.h"

// Files, lights and numbers that were meant for something else: messages say what they are and what
// to do.
namespace ptm {
namespace {

class WrongFile : public tests::Program {
 protected:
  [[nodiscard]] std::string map(int width = 4, int height = 3) const {
    golden::write_ptm(file("map.ptm"), tests::small_map(golden::MapKind::lrgb, width, height));
    return tests::quoted(file("map.ptm"));
  }
  [[nodiscard]] std::string picture() const {
    golden::Image8 image(4, 3, 3);
    golden::write_picture(file("picture.png"), image);
    return tests::quoted(file("picture.png"));
  }
  [[nodiscard]] std::string scene() const {
    return tests::quoted(write("scene.toml",
                               "[map]\nfile = 'map.ptm'\n[[light]]\n"
                               "direction = [0, 0]\n"));
  }
  [[nodiscard]] std::string lights() const {
    return tests::quoted(write("lights.lp", "1\npicture.png 0 0 1\n"));
  }
  [[nodiscard]] std::string to(const std::string& name) const {
    return " --out " + tests::quoted(file(name));
  }
};

TEST_F(WrongFile, IsNamedWithTheCommandThatTakesIt) {
  const std::string scene_commands = "`ptmsim run` and `plan` take a scene";
  const std::string map_commands = "`ptmsim info`, `render` and `convert` take a .ptm";
  const std::string hsh = tests::quoted(write("a.rti", "#HSH1.2\n3\n2 2 3\n9 1 1\n"));
  const auto source = map(), paints = picture(), draws = scene(), list = lights();
  const std::string light = " --light 0,0" + to("o.png");
  expect_refused("run " + source + to("o"), map_commands);
  expect_refused("plan " + source, map_commands);
  expect_refused("bump " + source + to("o.ptm"), map_commands);
  expect_refused("fit " + source + to("o.ptm"), map_commands);
  expect_refused("render " + draws + light, scene_commands);
  expect_refused("convert " + draws + " " + tests::quoted(file("o.ptm")), scene_commands);
  expect_refused("fit " + draws + to("o.ptm"), scene_commands);
  expect_refused("bump " + draws + to("o.ptm"), scene_commands);
  expect_refused("render " + paints + light, "`ptmsim bump` takes a picture");
  expect_refused("run " + paints + to("o"), "a picture (PNG)");
  expect_refused("fit " + paints + to("o.ptm"), "a picture (PNG)");
  expect_refused("render " + list + light, "`ptmsim fit` takes light positions");
  expect_refused("run " + list + to("o"), "`ptmsim fit` takes light positions");
  for (const std::string& command :
       std::vector<std::string>{"render " + hsh + light, "run " + hsh + to("o"),
                                "convert " + hsh + " " + tests::quoted(file("o.ptm")),
                                "fit " + hsh + to("o.ptm"), "bump " + hsh + to("o.ptm")}) {
    expect_refused(command, "hemispherical harmonics (HSH): 2 x 2 texels, 3 colours, 9 terms");
  }
}

TEST_F(WrongFile, WithinASceneIsNamedToo) {
  (void)picture();
  const auto flat = write("flat.toml", "map.file = 'picture.png'\n[[light]]\ndirection = [0, 0]\n");
  expect_refused("run " + tests::quoted(flat) + to("o"), "found a picture (PNG), expected a .ptm");
  (void)map();
  const auto unit = write("unit.toml",
                          "[[texture]]\nname = 'a'\npicture = 'map.ptm'\n[[object]]\n"
                          "kind = 'plane'\ncolor = 'a'\n[[light]]\ndirection = [0, 0, 1]\n");
  expect_refused("plan " + tests::quoted(unit), "found a polynomial texture map (.ptm)");
}

TEST_F(WrongFile, OutputsNeedTheExtensionOfWhatIsWritten) {
  const std::string source = map(), paints = picture();
  const std::string render = "render " + source + " --light 0,0";
  expect_refused(render + to("picture"),
                 "found a name without an extension, expected a name whose "
                 "extension chooses the format, as in picture.png");
  // A name that is a format's is no extension.
  expect_refused(render + to("png"), "a name without an extension");
  expect_refused(render + to("picture.xyz"), "found the extension .xyz");
  expect_refused(render + to("o.ptm"), "found the extension .ptm");
  expect_refused("convert " + source + " " + tests::quoted(file("o.png")), "ends in .ptm");
  expect_refused("bump " + paints + to("o.tif"), "ends in .ptm");
  expect_refused("fit " + lights() + to("o.jpg"), "ends in .ptm");
  expect_refused("fit " + lights() + to("o.ptm") + " --residual " + tests::quoted(file("r")),
                 "a name without an extension");
}

TEST_F(WrongFile, LightsInDegreesAreToldWhatTheyAreAsADirection) {
  const std::string render = "render " + map() + " --light ";
  // cos 30 cos 45 = cos 30 sin 45 = 0.6124; 45 and 30 are to 54.08 as 0.832 and 0.5547 are to 1.
  expect_refused(render + "45,30" + to("o.png"),
                 "the nearest light on the horizon is 0.832,0.554; azimuth 45 and elevation 30 in "
                 "degrees are 0.612,0.612");
  expect_refused(render + "-90,60" + to("o.png"), "in degrees are 0,-0.5");
  expect_refused(render + "1e154,1e154" + to("o.png"), "horizon is 0.707,0.707");
  const auto flat = write("flat.toml", "map.file = 'map.ptm'\n[[light]]\ndirection = [45, 30]\n");
  expect_refused("run " + tests::quoted(flat) + to("o"), "in degrees are 0.612,0.612");
}

TEST_F(WrongFile, LightsJustOutsideTheDiscAreDrawnWithANote) {
  const std::string render = "render " + map() + to("o.png") + " --light ";
  const tests::Outcome beyond = run(render + "0.9,0.9");
  EXPECT_EQ(beyond.code, 0) << beyond.err;
  EXPECT_NE(beyond.err.find("horizon is 0.707,0.707"), std::string::npos) << beyond.err;
  EXPECT_EQ(run(render + "0.6,0.8").err, "");
  const auto flat =
      write("flat.toml", "map.file = 'map.ptm'\n[[light]]\ndirection = [0.9, -0.9]\n");
  const tests::Outcome scene =
      run("run " + tests::quoted(flat) + to("o") + " --models golden,reference");
  EXPECT_EQ(scene.code, 0) << scene.err;
  EXPECT_NE(scene.out.find("light[0].direction): the map is extrapolated"), std::string::npos)
      << scene.out;
}

TEST_F(WrongFile, MapsBeyondTheHardwareAreNamedWithTheCommandThatCutsThem) {
  const std::string source = map(4097, 2);
  const std::string says = "found 4097 x 2 texels, expected at most 4096 a side";
  const std::string crop = "map.ptm PART.ptm --crop 0,0,4096,2`";
  const auto flat =
      tests::quoted(write("flat.toml", "map.file = 'map.ptm'\n[[light]]\ndirection = [0, 0]\n"));
  const auto unit =
      tests::quoted(write("unit.toml",
                          "[[texture]]\nname = 'wall'\nptm = 'map.ptm'\n[[object]]\n"
                          "kind = 'plane'\ntexture = 'wall'\n[[light]]\ndirection = [0, 0, 1]\n"));
  for (const std::string& what : {says, crop}) {
    expect_refused("run " + flat + to("o"), what);
    expect_refused("run " + unit + to("o"), what);
    expect_refused("plan " + unit, what);
    for (const char* model : {"reference", "pipeline", "rtl"}) {
      expect_refused("render " + source + " --light 0,0 --model " + model + to("o.png"), what);
    }
  }
  expect_refused("plan " + unit, "size of texture 'wall'");
  EXPECT_EQ(run("render " + source + " --light 0,0" + to("o.png")).code, 0) << "golden draws it";
  // The command that the message names makes a map that runs.
  const auto part = tests::quoted(file("PART.ptm"));
  ASSERT_EQ(run("convert " + source + " " + part + " --crop 0,0,4096,2").code, 0);
  EXPECT_EQ(run("render " + part + " --light 0,0 --model reference" + to("o.png")).code, 0);
}

TEST_F(WrongFile, LargePicturesAreRefusedBeforeTheyAreDecoded) {
  // 16384 x 16384 pixels as a BMP of zeros that take no room; decoded they take gigabytes.
  using namespace std::string_literals;
  const std::uintmax_t pixels = std::uintmax_t{1} << 28;
  const auto large = write("large.bmp",
                           "BM\0\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\0\x40\0\0\0\x40\0\0"
                           "\1\0\x18\0"s +
                               std::string(24, '\0'));
  std::filesystem::resize_file(large, std::filesystem::file_size(large) + 3 * pixels);
  const auto unit = write("unit.toml",
                          "[[texture]]\nname = 'a'\npicture = 'large.bmp'\n[[object]]\n"
                          "kind = 'plane'\ncolor = 'a'\n[[light]]\ndirection = [0, 0, 1]\n");
  const tests::Measured least = tests::run_measured({"info", file("none").string()});
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"plan", unit.string()},
        {"bump", large.string(), "--out", file("o.ptm").string()}}) {
    const tests::Measured refused = tests::run_measured(command);
    EXPECT_EQ(refused.code, 3);
    EXPECT_LT(refused.peak_kib, least.peak_kib + (1 << 17)) << "half a byte a pixel";
  }
}

TEST_F(WrongFile, NumbersWithoutASignHaveNone) {
  const std::string source = map(), list = lights();
  (void)picture();
  const std::string convert = "convert " + source + " " + tests::quoted(file("o.ptm"));
  const std::string fit = "fit " + list + to("o.ptm");
  const std::size_t before = count_files();
  for (const char* number : {"-5", "99999999999999999999"}) {
    for (const std::string& option : std::vector<std::string>{
             "vectors --count", "vectors --seed", "synthesize" + to("folder") + " --seed",
             "synthesize" + to("folder") + " --size", "synthesize" + to("folder") + " --lights"}) {
      EXPECT_EQ(run(option + " " + number).code, 2) << option << " " << number;
    }
    for (const char* option : {" --seed", " --palette", " --near", " --quality"}) {
      EXPECT_EQ(run(convert + option + " " + number).code, 2) << option << " " << number;
    }
    for (const char* option : {" --memory", " --robust", " --hold-out"}) {
      EXPECT_EQ(run(fit + option + " " + number).code, 2) << option << " " << number;
    }
    const std::string n = number;
    EXPECT_EQ(run(convert + " --crop 0,0,1," + n).code, 2) << n;
    EXPECT_EQ(run(convert + " --crop " + n + ",0,1,1").code, 2) << n;
    EXPECT_EQ(run(fit + " --region 0,0,1," + n).code, 2) << n;
    EXPECT_EQ(run("render " + source + " --light 0,0" + to("o.png") + " --size 3x" + n).code, 2)
        << n;
  }
  EXPECT_EQ(run("vectors --seed=-1").code, 2);
  EXPECT_EQ(count_files(), before);
}

}  // namespace
}  // namespace ptm
