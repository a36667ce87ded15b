// --preset, --set and `ptmsim config`, as a user has them.
#include <nlohmann/json.hpp>

#include "tests/program/small_map.h"
#include "tests/run_program.h"

namespace ptm {
namespace {

using nlohmann::json;
using tests::quoted;

const std::string kUnitScene = R"([image]
size = [24, 20]
[[texture]]
name = "m"
generate = "relief"
size = [32, 32]
[[object]]
kind = "plane"
texture = "m"
[[light]]
direction = [0, -0.4, 1]
)";

class ConfigCommand : public tests::Program {
 protected:
  std::string scene(const std::string& text) const { return quoted(write("scene.toml", text)); }
  std::string map() const {
    golden::write_ptm(file("map.ptm"), tests::small_map(golden::MapKind::lrgb, 9, 7));
    return quoted(file("map.ptm"));
  }
  std::string flat_scene() const {
    (void)map();
    return scene("[map]\nfile = \"map.ptm\"\n[[light]]\ndirection = [0.3, -0.2]\n");
  }
  std::string out() const { return " --out " + quoted(file("report")); }
  json report(const std::string& folder = "report") const {
    return json::parse(tests::text_of(file(folder) / "report.json"));
  }
  static void expect_agreement(const json& found) {
    for (const json& pair : found.at("differences")) {
      if (pair.at("a") == "golden") continue;
      EXPECT_EQ(pair.at("differing"), 0) << pair;
    }
    EXPECT_TRUE(found.at("agree"));
  }
};

TEST_F(ConfigCommand, PrintsAConfigurationThatASceneTakesBack) {
  const std::string sets = "--preset wide --set guard=6 --set tmus=2 --set memory.kind=random";
  const auto toml = run("config --format toml " + sets);
  ASSERT_EQ(toml.code, 0) << toml.err;
  EXPECT_NE(toml.out.find("\nguard = 6\n"), std::string::npos) << toml.out;
  EXPECT_NE(toml.out.find("\nlight_frac = 12\n"), std::string::npos) << toml.out;
  EXPECT_NE(toml.out.find("\nrounding = \"nearest\"\n"), std::string::npos) << toml.out;
  EXPECT_NE(toml.out.find("[memory]\nkind = \"random\"\n"), std::string::npos) << toml.out;
  const auto models = " --models reference,pipeline";
  ASSERT_EQ(run("run " + scene(kUnitScene) + out() + models + " " + sets).code, 0);
  json by_set = report();
  ASSERT_EQ(run("run " + scene(kUnitScene + toml.out) + out() + models).code, 0);
  json by_toml = report();
  EXPECT_EQ(by_set.at("scene").at("preset"), "wide with guard = 6");
  EXPECT_EQ(by_toml.at("scene").at("preset"), "wide with guard = 6");
  EXPECT_EQ(by_set.at("models").at("pipeline").at("counters"),
            by_toml.at("models").at("pipeline").at("counters"));
  EXPECT_EQ(by_set.at("unit").at("memory"), by_toml.at("unit").at("memory"));
  const auto rtl = run("config --format rtl " + sets);
  EXPECT_NE(rtl.out.find("\nGuard=6\n"), std::string::npos) << rtl.out;
  EXPECT_NE(rtl.out.find("\nTmus=2\n"), std::string::npos) << rtl.out;
  const auto all = run("config " + sets);
  EXPECT_EQ(all.out.rfind("# wide with guard = 6\n", 0), 0U) << all.out;
  EXPECT_NE(all.out.find(" -GGuard=6 "), std::string::npos) << all.out;
}

TEST_F(ConfigCommand, PrintsACommandThatVerilatorTakes) {
  const auto line = run("config --format verilator --set guard=7 --set cache_kib=2 --set ways=4");
  ASSERT_EQ(line.code, 0) << line.err;
  const auto lint = file("lint.txt");
  const std::string command = "cd " + quoted(PTM_SOURCE_DIR) + " && " +
                              line.out.substr(0, line.out.size() - 1) + " >" + quoted(lint) +
                              " 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << tests::text_of(lint);
}

TEST_F(ConfigCommand, ChangesWhatIsDrawnOfAFlatMapInAllModels) {
  const std::string path = flat_scene();
  ASSERT_EQ(run("run " + path + out()).code, 0);
  const json base = report();
  const auto changed = run("run " + path + out() + " --set guard=0 --set lum_frac=2");
  ASSERT_EQ(changed.code, 0) << changed.err;
  const json found = report();
  expect_agreement(found);
  EXPECT_NE(changed.out.find("0 pixels go in different cycles"), std::string::npos) << changed.out;
  EXPECT_EQ(base.at("scene").at("preset"), "base");
  EXPECT_EQ(found.at("scene").at("preset"), "base with guard = 0, lum_frac = 2");
  ASSERT_EQ(found.at("presets").size(), 4U);
  EXPECT_EQ(found.at("presets").at(0).at("preset"), "base with guard = 0, lum_frac = 2");
  EXPECT_NE(found.at("presets").at(0).at("rmse"), found.at("presets").at(2).at("rmse"));
  // The RTL is that of these parameters: with base's it would differ from the reference.
  EXPECT_NE(base.at("differences").at(0).at("rmse"), found.at("differences").at(0).at("rmse"));
}

TEST_F(ConfigCommand, TakesEveryParameterInAScenesHardware) {
  const std::string path = scene(kUnitScene +
                                 "[hardware]\nguard = 2\nlight_frac = 10\n"
                                 "rounding = \"truncate\"\nextra_passes = 2\n");
  ASSERT_EQ(run("run " + path + out() + " --models reference,pipeline").code, 0);
  EXPECT_EQ(report().at("scene").at("preset"),
            "base with light_frac = 10, guard = 2, rounding = truncate");
  const auto plan = run("plan " + path + " --json");
  ASSERT_EQ(plan.code, 0) << plan.err;
  EXPECT_EQ(json::parse(plan.out).at("hardware").at("extra_passes"), 2);
}

TEST_F(ConfigCommand, DrawsAScenePresetByPreset) {
  const auto outcome =
      run("run " + scene(kUnitScene) + out() + " --models golden,reference --preset base,wide");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(report("report/base").at("scene").at("preset"), "base");
  EXPECT_EQ(report("report/wide").at("scene").at("preset"), "wide");
  EXPECT_NE(outcome.out.find("\npreset      PSNR against golden"), std::string::npos);
  EXPECT_NE(outcome.out.find("\nbase "), std::string::npos);
  EXPECT_NE(outcome.out.find("\nwide "), std::string::npos);
}

TEST_F(ConfigCommand, IsTheSameOfVectorsRenderConvertFitAndInfo) {
  const auto base = run("vectors --count 50"), set = run("vectors --count 50 --set guard=0");
  const auto pipeline = run("vectors --count 50 --set guard=0 --model pipeline");
  ASSERT_EQ(set.code, 0) << set.err;
  EXPECT_EQ(pipeline.out, set.out);
  EXPECT_NE(base.out, set.out);

  const std::string in = map();
  const std::string light = " --light 0.2,0.1 --model reference --set lum_bits=8 --out ";
  ASSERT_EQ(run("render " + in + light + quoted(file("a.png"))).code, 0);
  const std::string other = " --light 0.2,0.1 --model pipeline --set lum_bits=8 --out ";
  ASSERT_EQ(run("render " + in + other + quoted(file("b.png"))).code, 0);
  EXPECT_EQ(tests::text_of(file("a.png")), tests::text_of(file("b.png")));

  const auto narrow =
      run("convert " + in + " " + quoted(file("narrow.ptm")) + " --set coef_bits=5 --json");
  ASSERT_EQ(narrow.code, 0) << narrow.err;
  EXPECT_EQ(json::parse(narrow.out).at("steps").at(0).at("step"), "hold");
  const golden::PtmMap held = golden::read_ptm(file("narrow.ptm")).map;
  EXPECT_LT(*std::max_element(held.coef.begin(), held.coef.end()), 32);

  const auto info = run("info " + in + " --set guard=11 --json");
  ASSERT_EQ(info.code, 0) << info.err;
  EXPECT_EQ(json::parse(info.out).at("presets").at(3).at("preset"), "base with guard = 11");
}

TEST_F(ConfigCommand, RefusesWhatCannotBeBuiltNamingTheParameterBeforeAnythingRuns) {
  const std::string unit = scene(kUnitScene), in = map();
  const std::string lp =
      quoted(std::filesystem::path(PTM_SOURCE_DIR) / "scenes/data/stone/capture.lp");
  const std::string render =
      "render " + in + " --light 0,0 --model rtl --out " + quoted(file("a.png"));
  const std::string commands[] = {"run " + unit + out(),
                                  "plan " + unit,
                                  "config",
                                  "vectors",
                                  render,
                                  "convert " + in + " " + quoted(file("out.ptm")),
                                  "info " + in,
                                  "fit " + lp + " --out " + quoted(file("fit.ptm"))};
  struct Illegal {
    const char *name, *set;
  };
  for (const Illegal& illegal : {Illegal{"coef_bits", "coef_bits=13"},
                                 {"delta_bits", "delta_bits=4"},
                                 {"light_int", "light_int=0"},
                                 {"basis_frac", "basis_frac=17"},
                                 {"guard", "guard=-1"},
                                 {"rounding", "rounding=up"},
                                 {"shift_groups", "shift_groups=4"},
                                 {"tmus", "tmus=0"},
                                 {"cache_kib", "cache_kib=12"},
                                 {"miss_fifo", "miss_fifo=11"},
                                 {"extra_sets", "extra_sets=1"},
                                 {"duplicate_lines", "counters=false --set duplicate_lines=true"},
                                 {"eval_lanes", "eval_lanes=2"},
                                 {"colour", "colour=3"}}) {
    for (const std::string& command : commands) {
      expect_refused(command + " --set " + illegal.set, illegal.name);
    }
  }
  expect_refused("config --set coef_bits=13", "coef_bits = 13");
  EXPECT_EQ(run("config --set coef_bits=11").code, 0);
  EXPECT_EQ(run("vectors --count 3 --set coef_bits=11").code, 0);
  expect_refused("fit " + lp + " --out " + quoted(file("fit.ptm")) + " --set coef_bits=9",
                 "coef_bits = 9, expected at most 8");
  expect_refused("run " + unit + out() + " --set memory.interval=0", "interval = 0");
}

TEST_F(ConfigCommand, RefusesLessThanTheScenesEffectsNeed) {
  const std::string path =
      quoted(std::filesystem::path(PTM_SOURCE_DIR) / "scenes/effect_half_vector.toml");
  expect_refused("run " + path + out() + " --set extra_passes=1 --set half_vector=false",
                 "half_vector = false, expected true, which the scene's effects need");
  ASSERT_EQ(run("plan " + path + " --set extra_passes=2").code, 0) << "more is no fault";
}

TEST_F(ConfigCommand, TakesNoSetThatIsNoNameAndValue) {
  for (const char* set : {"guard", "=6", "preset=wide"}) {
    EXPECT_EQ(run(std::string("config --set ") + set).code, 2) << set;
  }
}

}  // namespace
}  // namespace ptm
