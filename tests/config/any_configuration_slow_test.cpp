// Any configuration: random ones, by --set alone, through all four models.
#include <nlohmann/json.hpp>

#include "tests/config/random_configuration.h"
#include "tests/run_program.h"

namespace ptm {
namespace {

using nlohmann::json;

class AnyConfiguration : public tests::Program, public testing::WithParamInterface<int> {};

/// Pixels, cycles and counters of the models that must agree.
void expect_agreement(const json& report) {
  EXPECT_TRUE(report.at("agree"));
  for (const json& pair : report.at("differences")) {
    if (pair.at("a") == "golden") continue;
    EXPECT_EQ(pair.at("differing"), 0) << pair;
  }
  EXPECT_EQ(report.at("unit").at("late_pixels"), 0);
  EXPECT_EQ(report.at("unit").at("differing_counters"), json::array());
}

TEST_P(AnyConfiguration, DrawsTwoScenesWithFourModelsThatAgree) {
  std::mt19937_64 rng(static_cast<unsigned>(1000 + GetParam()));
  std::string sets;
  for (const auto& [name, text] : tests::random_parameters(rng)) {
    sets += " --set " + name + "=" + text;
  }
  for (const char* scene : {"combine_palette_add", "rgb_2_tmus"}) {
    const std::string path = std::string(PTM_SOURCE_DIR) + "/scenes/" + scene + ".toml";
    const auto outcome =
        run("run " + tests::quoted(path) + " --out " + tests::quoted(file(scene)) + sets);
    ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out << sets;
    expect_agreement(json::parse(tests::text_of(file(scene) / "report.json")));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, AnyConfiguration, testing::Range(0, 12));

}  // namespace
}  // namespace ptm
