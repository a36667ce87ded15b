#include <nlohmann/json.hpp>

#include "golden/files/picture_file.h"
#include "tests/program/small_map.h"
#include "tests/run_program.h"

namespace ptm {
namespace {

using nlohmann::json;

/// Two runs of the same scene in the folders a and b.
class CompareCommand : public tests::Program {
 protected:
  CompareCommand() {
    golden::write_ptm(file("map.ptm"), tests::small_map(golden::MapKind::lrgb, 14, 10));
    write("scene.toml", "[map]\nfile = \"map.ptm\"\n[[light]]\ndirection = [0.3, 0.4]\n");
    const tests::Outcome outcome =
        run("run " + quoted("scene.toml") + " --models pipeline,rtl" + " --out " + quoted("a"));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::filesystem::copy(file("a"), file("b"));
  }
  std::string quoted(const std::string& name) const { return tests::quoted(file(name)); }
  std::string compare(const std::string& rest = {}) const {
    return "compare " + quoted("a") + " " + quoted("b") + " " + rest;
  }
  void set_cycles(int cycles) const {
    json report = json::parse(tests::text_of(file("b") / "report.json"));
    report["models"]["rtl"]["cycles"] = cycles;
    write("b/report.json", report.dump());
  }
  static std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }
};

TEST_F(CompareCommand, EndsWithNothingToSayOfEqualRuns) {
  const tests::Outcome outcome = run(compare());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(first_line(outcome.out), "same: nothing differs but what made the runs and when");
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("A: " + (file("a") / "report.json").string() + ", scene " +
                             file("scene.toml").string()),
            std::string::npos)
      << outcome.out;
}

TEST_F(CompareCommand, EndsWithOneUnlessTheToleranceFileAllowsWhatDiffers) {
  set_cycles(150);  // of 148
  tests::Outcome outcome = run(compare());
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(first_line(outcome.out), "different: 1 difference that is not allowed");
  EXPECT_NE(outcome.out.find("\ncycles  models.rtl.cycles  148 -> 150 (+1.351 %)\n"),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.err.find("1 thing that the comparison does not allow"), std::string::npos);
  write("t.toml", "[cycles]\nrelative = 0.02\n");
  outcome = run(compare("--tolerance " + quoted("t.toml")));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(first_line(outcome.out),
            "same within " + file("t.toml").string() + ": 1 difference, allowed");
  write("t.toml", "[cycles]\nrelative = 0.01\n");
  EXPECT_EQ(run(compare("--tolerance " + quoted("t.toml"))).code, 1);
}

TEST_F(CompareCommand, CountsPixelsInTextAndJson) {
  golden::ImageReal real = golden::read_picture(file("b") / "rtl.png");
  golden::Image8 picture(real.width, real.height, 3);
  for (std::size_t i = 0; i < picture.samples.size(); ++i) {
    picture.samples[i] = static_cast<std::uint8_t>(real.samples[i]);
  }
  std::uint8_t& sample = picture.at(9, 6, 2);
  sample = static_cast<std::uint8_t>(sample < 128 ? sample + 5 : sample - 5);
  golden::write_picture(file("b") / "rtl.png", picture);
  tests::Outcome outcome = run(compare());
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.out.find("pixels  models.rtl.pictures  1 of 420 samples differ, at most 5 "
                             "levels; worst in rtl.png at x 9, y 6\n"),
            std::string::npos)
      << outcome.out;
  outcome = run(compare("--json"));
  EXPECT_EQ(outcome.code, 1);
  const json found = json::parse(outcome.out);
  EXPECT_EQ(found.at("verdict"), "different");
  EXPECT_EQ(found.at("a").at("scene"), file("scene.toml").string());
  EXPECT_EQ(found.at("b").at("report"), (file("b") / "report.json").string());
  EXPECT_TRUE(found.at("tolerance").is_null());
  EXPECT_EQ(found.at("not_allowed"), 1);
  const json& difference = found.at("differences").at(0);
  EXPECT_EQ(difference.at("kind"), "pixels");
  EXPECT_EQ(difference.at("path"), "models.rtl.pictures");
  EXPECT_EQ(difference.at("allowed"), false);
  EXPECT_EQ(difference.at("pixels").at("differing"), 1);
  EXPECT_EQ(difference.at("pixels").at("max"), 5);
  EXPECT_EQ(difference.at("pixels").at("files").at(0).at("picture"), "rtl.png");
}

TEST_F(CompareCommand, GivesBothValuesInJson) {
  set_cycles(111);
  write("t.toml", "[cycles]\ndecrease = true\n");
  const tests::Outcome outcome = run(compare("--json --tolerance " + quoted("t.toml")));
  EXPECT_EQ(outcome.code, 0);
  const json found = json::parse(outcome.out);
  EXPECT_EQ(found.at("verdict"), "allowed");
  EXPECT_EQ(found.at("tolerance"), file("t.toml").string());
  const json& difference = found.at("differences").at(0);
  EXPECT_EQ(difference.at("a"), 148);
  EXPECT_EQ(difference.at("b"), 111);
  EXPECT_EQ(difference.at("difference"), -37);
  EXPECT_EQ(difference.at("relative"), -0.25);
}

TEST_F(CompareCommand, RefusesWhatCannotBeComparedWithThree) {
  expect_refused("compare " + quoted("a") + " " + quoted("nowhere"), "nowhere");
  expect_refused("compare " + quoted("a") + " " + quoted("scene.toml"), "scene.toml: line 1");
  write("t.toml", "[cycles]\nrelative = \"much\"\n");
  expect_refused(compare("--tolerance " + quoted("t.toml")), "line 2 (cycles.relative)");
  write("b/rtl.png", "no picture");
  expect_refused(compare(), "rtl.png");
  json report = json::parse(tests::text_of(file("a") / "report.json"));
  report["version"] = 7;
  write("a/report.json", report.dump());
  expect_refused(compare(), "found a report of version 7, expected version 2");
}

TEST_F(CompareCommand, EndsWithTwoWhenUsedWrongly) {
  EXPECT_EQ(run("compare " + quoted("a")).code, 2);
  EXPECT_EQ(run(compare("--tolerances x")).code, 2);
  EXPECT_EQ(run("compare --help").code, 0);
}

}  // namespace
}  // namespace ptm
