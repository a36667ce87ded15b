#include <nlohmann/json.hpp>

#include "tests/run_program.h"

namespace ptm {
namespace {

using nlohmann::json;

class PlanCommand : public tests::Program {
 protected:
  std::string scene(const std::string& effects) const {
    return tests::quoted(write("scene.toml",
                               "[[texture]]\nname = \"m\"\ngenerate = \"studs\"\nsize = [16, 16]\n"
                               "[[object]]\nkind = \"sphere\"\ntexture = \"m\"\n" +
                                   effects + "[[light]]\ndirection = [0, -1, 1]\n"));
  }
};

const std::string kHighlight = "[[object.effect]]\nkind = \"half-vector\"\n";
const std::string kFresnel = "[[object.effect]]\nkind = \"fresnel\"\n";

TEST_F(PlanCommand, PrintsWhatASceneCallsForAndWhatAPixelWillCost) {
  const auto outcome = run("plan " + scene(kHighlight + kFresnel));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("extra_sets: 3 coefficient sets, for fresnel\n"), std::string::npos);
  EXPECT_NE(outcome.out.find("draw 0: map m; effects: half-vector, fresnel\n"), std::string::npos);
  EXPECT_NE(outcome.out.find("9 words a texel, 1 pass of the map's and 4 of effects"),
            std::string::npos)
      << outcome.out;
}

TEST_F(PlanCommand, SaysTheSameAsJson) {
  const auto outcome = run("plan " + scene(kHighlight) + " --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json plan = json::parse(outcome.out);
  EXPECT_EQ(plan.at("hardware"), json::parse(R"({"half_vector": true, "extra_sets": 0,
                                                 "extra_passes": 1, "stages": 5})"));
  EXPECT_EQ(plan.at("draws").at(0).at("least").at("cycles"), 2);
  EXPECT_EQ(plan.at("draws").at(0).at("least").at("multiplies").at("effects"), 1);
}

TEST_F(PlanCommand, NamesNoBlockForASceneWithoutEffects) {
  const auto outcome = run("plan " + scene("") + " --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out).at("blocks"), json::array());
  EXPECT_NE(run("plan " + scene("")).out.find("no effect needs hardware of its own"),
            std::string::npos);
}

TEST_F(PlanCommand, RefusesAnUnknownEffectListingThoseThereAre) {
  expect_refused("plan " + scene("[[object.effect]]\nkind = \"glow\"\n"), "half-vector");
}

TEST_F(PlanCommand, RefusesAModulatorWithoutAHighlight) {
  expect_refused("plan " + scene(kFresnel), "line 8 (object[0].effect[0]): found fresnel");
}

TEST_F(PlanCommand, RefusesAFlatScene) {
  expect_refused("plan " + tests::quoted(write("flat.toml", "[map]\nfile = \"m.ptm\"\n")),
                 "found a flat scene");
}

/// What an effect costs is what the scene has less without it.
TEST_F(PlanCommand, AndRunAgreeOnWhatAHighlightCosts) {
  const auto outcome = run("run " + scene(kHighlight) + " --cost-of-effects --out " +
                           tests::quoted(file("report")) + " --models golden,reference,pipeline");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json report = json::parse(tests::text_of(file("report") / "report.json"));
  const json& costs = report.at("effects");
  ASSERT_EQ(costs.at("without").size(), 1U);
  const json& without = costs.at("without").at(0);
  EXPECT_EQ(without.at("effect"), "half-vector");
  const std::uint64_t pixels =
      report.at("unit").at("timings").at("pipeline").at("counters").at("pixels");
  const auto more = [&](const char* kind) {
    return costs.at("with").at("multiplies").at(kind).get<std::uint64_t>() -
           without.at("multiplies").at(kind).get<std::uint64_t>();
  };
  EXPECT_EQ(more("eval"), 8 * pixels);
  EXPECT_EQ(more("effects"), pixels);
  EXPECT_EQ(costs.at("with").at("words"), without.at("words"));
  EXPECT_GE(costs.at("with").at("cycles").get<std::uint64_t>(),
            without.at("cycles").get<std::uint64_t>() + pixels / 2);
  EXPECT_GT(without.at("picture").at("changed").get<double>(), 0);
  EXPECT_NE(tests::text_of(file("report") / "report.html").find("What each effect costs"),
            std::string::npos);
}

TEST_F(PlanCommand, AndItsPriceSurviveASceneThatIsNoLegalOneWithoutAnEffect) {
  const std::string path =
      tests::quoted(write("day.toml",
                          "[[texture]]\nname = \"m\"\ngenerate = \"tide\"\nsize = [8, 8]\n"
                          "[[object]]\nkind = \"plane\"\ntexture = \"m\"\n"
                          "[[object.effect]]\nkind = \"time\"\ncoordinates = [0.5, 0]\n"
                          "[[light]]\ndirection = [3, 0]\n"));
  const auto outcome = run("run " + path + " --cost-of-effects --out " +
                           tests::quoted(file("report")) + " --models golden,reference");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json costs = json::parse(tests::text_of(file("report") / "report.json")).at("effects");
  EXPECT_EQ(costs.at("without"), json::array());
  EXPECT_NE(costs.at("notes").dump().find("the scene cannot be drawn without time, at line 12"),
            std::string::npos)
      << costs.at("notes");
  EXPECT_TRUE(costs.at("with").at("cycles").is_null()) << "no model of time ran";
}

TEST_F(PlanCommand, OfASceneWithoutEffectsLeavesNoTraceInTheReport) {
  const auto outcome = run("run " + scene("") + " --out " + tests::quoted(file("report")) +
                           " --models reference,pipeline");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string text = tests::text_of(file("report") / "report.json");
  EXPECT_EQ(text.find("effect"), std::string::npos);
  EXPECT_EQ(tests::text_of(file("report") / "report.html").find("multiplies_effects"),
            std::string::npos);
}

}  // namespace
}  // namespace ptm
