#include <nlohmann/json.hpp>
#include <regex>

#include "tests/program/small_map.h"
#include "tests/run_program.h"
#include "tests/shared_data.h"

namespace ptm {
namespace {

using nlohmann::json;

class RunCommand : public tests::Program {
 protected:
  std::string scene(const std::string& rest, const std::string& map = "map.ptm") const {
    return quoted(write("scene.toml", "[map]\nfile = \"" + map + "\"\n" + rest));
  }
  void write_map(golden::MapKind kind, int width, int height) const {
    golden::write_ptm(file("map.ptm"), tests::small_map(kind, width, height));
  }
  std::string out() const { return " --out " + quoted(file("report")); }
  json report() const { return json::parse(tests::text_of(file("report") / "report.json")); }

  static json difference(const json& report, const std::string& a, const std::string& b) {
    for (const json& pair : report.at("differences")) {
      if (pair.at("a") == a && pair.at("b") == b) return pair;
    }
    return {};
  }
  void expect_hardware_agrees(const json& found) const {
    EXPECT_EQ(difference(found, "reference", "pipeline").at("differing"), 0);
    EXPECT_EQ(difference(found, "reference", "rtl").at("differing"), 0);
    EXPECT_EQ(difference(found, "pipeline", "rtl").at("differing"), 0);
  }

  static std::string quoted(const std::filesystem::path& path) { return tests::quoted(path); }
};

const std::string kLight = "[[light]]\ndirection = [-0.4, 0.3]\n";

TEST_F(RunCommand, DrawsARealMapWithFourModelsThatAgree) {
  PTM_SHARED_DATA_OR_SKIP(map, "tablet2/tablet2_LRGB.ptm");
  const auto path = scene(kLight, std::filesystem::absolute(map).string());
  const tests::Outcome outcome = run("run " + path + out());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json found = report();
  expect_hardware_agrees(found);
  EXPECT_EQ(difference(found, "golden", "reference").at("samples"), 786432);
  EXPECT_GT(difference(found, "golden", "reference").at("psnr_db"), 56.5);
  EXPECT_EQ(found.at("presets").size(), 3U);
  EXPECT_EQ(found.at("models").at("rtl").at("cycles"), 262144 + 8);
  EXPECT_EQ(found.at("models").at("pipeline").at("cycles"), 262144 + 8 + 4);
  EXPECT_EQ(found.at("models").at("pipeline").at("counters").at("words_fetched"), 3 * 262144);
  EXPECT_NE(outcome.out.find("0 pixels go in different cycles"), std::string::npos);
}

TEST_F(RunCommand, DrawsEveryKindOfMapOnAnyNumberOfTmusWithModelsThatAgree) {
  for (const auto kind : {golden::MapKind::lrgb, golden::MapKind::rgb, golden::MapKind::lum}) {
    write_map(kind, 19, 7);
    for (const std::string tmus : {"1", "2", "3"}) {
      const auto path = scene(kLight + "[[light]]\ndirection = [0.9, -0.9]\n" +
                              "[hardware]\npreset = \"wide\"\ntmus = " + tmus + "\n");
      const tests::Outcome outcome = run("run " + path + out());
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      expect_hardware_agrees(report());
      EXPECT_NE(outcome.out.find("0 pixels go in different cycles"), std::string::npos);
    }
  }
}

TEST_F(RunCommand, GivesEveryIntermediateValueOfTheWorstPixelsInFourModels) {
  write_map(golden::MapKind::lrgb, 16, 16);
  ASSERT_EQ(run("run " + scene(kLight) + out()).code, 0);
  const json found = report();
  ASSERT_EQ(found.at("worst").size(), 10U);
  for (const json& pixel : found.at("worst")) {
    const json& models = pixel.at("models");
    for (const char* name : {"reference", "pipeline", "rtl"}) {
      for (const char* value : {"coef0", "d5", "uv", "p3", "t2", "acc", "lum", "product_g"}) {
        EXPECT_EQ(models.at(name).at("values").at(value),
                  models.at("reference").at("values").at(value))
            << name << " " << value;
      }
    }
    EXPECT_TRUE(models.at("golden").at("values").contains("acc"));
  }
}

TEST_F(RunCommand, DrawsOnlyTheModelsThatAreAskedForAtTheSizeThatIsAskedFor) {
  write_map(golden::MapKind::lrgb, 8, 8);
  const auto path = scene("[image]\nsize = [24, 16]\n" + kLight);
  ASSERT_EQ(run("run " + path + out() + " --models golden,pipeline").code, 0);
  const json found = report();
  EXPECT_EQ(found.at("models").size(), 2U);
  EXPECT_EQ(found.at("differences").size(), 1U);
  EXPECT_EQ(found.at("differences")[0].at("samples"), 24 * 16 * 3);
}

TEST_F(RunCommand, RefusesALightThatThePresetCannotExpressNamingIt) {
  write_map(golden::MapKind::lrgb, 8, 8);
  expect_refused(
      "run " + scene("[[light]]\ndirection = [1.5, 0]\n[hardware]\npreset = \"paper8\"\n") + out(),
      "line 4 (light[0].direction): found lu = 1.5, expected |lu| at most 1");
  ASSERT_EQ(run("run " + scene("[[light]]\ndirection = [1.5, 0]\n") + out()).code, 0)
      << "base has two integer bits";
  EXPECT_EQ(report().at("presets").size(), 2U);
}

TEST_F(RunCommand, RefusesASceneWithAFaultAndLeavesNothingBehind) {
  write_map(golden::MapKind::lrgb, 8, 8);
  expect_refused("run " + scene(kLight + "colour = 3\n") + out(), "line 5: found unknown key");
  expect_refused("run " + scene("[[light]]\ndirection = 3\n") + out(),
                 "line 4 (light[0].direction)");
  expect_refused("run " + scene(kLight + "[hardware]\npreset = \"huge\"\n") + out(),
                 "line 6 (hardware.preset): found preset 'huge', expected paper8, base or wide");
  expect_refused("run " + scene(kLight, "absent.ptm") + out(), "absent.ptm");
  expect_refused("run " + quoted(file("absent.toml")) + out(), "absent.toml");
  expect_refused("run " + quoted(write("bad.toml", "[map\n")) + out(), "bad.toml: line 1");
}

TEST_F(RunCommand, RefusesAMapThatTheHardwareCannotAddress) {
  write_map(golden::MapKind::lrgb, 4097, 1);
  expect_refused(
      "run " + scene(kLight) + out(),
      "found 4097 x 1 texels, expected at most 4096 a side in the hardware; `ptmsim convert");
}

/// At half its size, every sample of a map is a tie between texels; 1/5 is not exact in 2^-20.
TEST_F(RunCommand, TellsSamplesOnEdgesBetweenTexelsAndTheErrorWithoutThem) {
  write_map(golden::MapKind::lrgb, 10, 10);
  const tests::Outcome outcome = run("run " + scene("[image]\nsize = [5, 5]\n" + kLight) + out() +
                                     " --models golden,reference");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json found = report();
  const std::string page = tests::text_of(file("report") / "report.html");
  // The middle column and row lie at 1/2, which is not rounded.
  EXPECT_EQ(found.at("edge_samples"), (25 - 1) * 3);
  const json pair = difference(found, "golden", "reference");
  EXPECT_EQ(pair.at("off_edges").at("samples"), 3);
  // What is left is the number format's error, which the map at its own size bounds: there every
  // texel is compared with itself.
  ASSERT_EQ(run("run " + scene(kLight) + out() + " --models golden,reference").code, 0);
  const double most = difference(report(), "golden", "reference").at("max");
  EXPECT_LE(pair.at("off_edges").at("max"), most);
  EXPECT_GT(pair.at("max"), most);
  EXPECT_EQ(found.at("presets").at(1).at("off_edges").at("samples"), 3);
  EXPECT_NE(outcome.out.find("72 of 75 samples lie on an edge between texels"), std::string::npos)
      << outcome.out;
  EXPECT_NE(page.find("72 of 75 samples lie on an edge between texels"), std::string::npos);
  EXPECT_NE(page.find("without samples on edges"), std::string::npos);
}

TEST_F(RunCommand, SaysNothingOfEdgesWhereNoSampleLiesOnOne) {
  write_map(golden::MapKind::lrgb, 10, 10);
  const tests::Outcome outcome = run("run " + scene(kLight) + out() + " --models golden,reference");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(report().at("edge_samples"), 0);
  EXPECT_TRUE(difference(report(), "golden", "reference").at("off_edges").is_null());
  EXPECT_EQ(outcome.out.find("on an edge"), std::string::npos);
}

TEST_F(RunCommand, EndsWithTwoWhenUsedWrongly) {
  EXPECT_EQ(run("run").code, 2);
  EXPECT_EQ(run("run scene.toml --out x --models vulkan").code, 2);
  EXPECT_EQ(run("").code, 2);
  EXPECT_EQ(run("--help").code, 0);
}

TEST_F(RunCommand, IsOfAProgramThatSaysItsVersionAndCommit) {
  const tests::Outcome outcome = run("--version");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(std::regex_match(
      outcome.out, std::regex("ptmsim [0-9]+\\.[0-9]+\\.[0-9]+, commit (unknown|[0-9a-f]{40})"
                              "(, sources changed since)?\n")))
      << outcome.out;
}

TEST_F(RunCommand, WritesTheSameAgainButForWhatMadeItAndTheTimes) {
  write_map(golden::MapKind::rgb, 18, 11);
  const auto path = scene(kLight + "[hardware]\npreset = \"wide\"\ntmus = 2\n");
  const auto report_of = [&](const std::string& folder) {
    const std::string arguments = "run " + path + " --out " + quoted(file(folder));
    EXPECT_EQ(run(arguments).code, 0);
    return nlohmann::ordered_json::parse(tests::text_of(file(folder) / "report.json"));
  };
  nlohmann::ordered_json first = report_of("a"), second = report_of("b");
  EXPECT_EQ(first["made_by"]["command"].size(), 5U);
  EXPECT_EQ(first["made_by"]["command"][1], "run");
  EXPECT_EQ(first["made_by"]["command"][4], file("a").string());
  EXPECT_EQ(second["made_by"]["command"][4], file("b").string());
  EXPECT_GT(first["timing"]["models"]["rtl"], 0);
  EXPECT_EQ(first["config"]["evaluator"]["guard"], 10) << "of the preset wide";
  EXPECT_EQ(first["config"]["unit"]["tmus"], 2);
  for (auto* report : {&first, &second}) {
    report->erase("made_by");
    report->erase("timing");
  }
  EXPECT_EQ(first.dump(), second.dump());
  for (const char* model : {"golden", "reference", "pipeline", "rtl"}) {
    const std::string picture = std::string(model) + ".png";
    EXPECT_EQ(tests::text_of(file("a") / picture), tests::text_of(file("b") / picture));
  }
}

}  // namespace
}  // namespace ptm
