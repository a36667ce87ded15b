// Configurations from what scenes and command lines say.
#include "testbench/config/configuration.h"

#include <random>

#include "golden/files/input_error.h"
#include "golden/scene/unit_scene.h"
#include "tests/config/random_configuration.h"
#include "tests/scratch_folder.h"

namespace ptm::testbench {
namespace {

using golden::Setting;
using golden::Settings;

Setting told(const std::string& name, const std::string& text,
             Setting::Kind kind = Setting::Kind::any) {
  const bool line = kind == Setting::Kind::any;
  return {.name = name,
          .text = text,
          .key = line ? name : "hardware." + name,
          .place = line ? "--set " + name + "=" + text : "line 7",
          .kind = kind};
}

/// "place|found|expected" of what is refused; "" of what is not.
std::string complaint(const std::vector<Setting>& hardware,
                      const std::vector<Setting>& memory = {}) {
  const Settings of_hardware{"line 6 (hardware)", hardware}, of_memory{"line 9 (memory)", memory};
  try {
    (void)make_unit_configuration({"scene.toml", of_hardware, of_memory});
    return "";
  } catch (const golden::InputError& error) {
    return error.place() + "|" + error.found() + "|" + error.expected();
  }
}

Configuration made(const std::vector<Setting>& hardware, const std::vector<Setting>& memory = {}) {
  const Settings of_hardware{"", hardware}, of_memory{"", memory};
  return make_unit_configuration({"scene.toml", of_hardware, of_memory});
}

TEST(Configuration, WithoutSettingsIsBaseAndAFixedMemory) {
  const Configuration configuration = made({});
  EXPECT_EQ(configuration.eval, reference::kBase);
  EXPECT_EQ(configuration.unit, reference::UnitConfig{});
  const auto& memory = std::get<pipeline::FixedMemory>(configuration.memory);
  EXPECT_EQ(memory.latency, 100U);
  EXPECT_EQ(memory.interval, 4U);
}

TEST(Configuration, TakesParametersByTheirNamesOnTopOfAPreset) {
  const Configuration configuration =
      made({told("guard", "6"), told("preset", "wide"), told("rounding", "truncate"),
            told("tmus", "2"), told("counters", "false"), told("guard", "7")},
           {told("kind", "dram"), told("tRCD", "11")});
  reference::EvalConfig expected = reference::kWide;
  expected.guard = 7;  // the last one counts
  expected.rounding = reference::Rounding::truncate;
  EXPECT_EQ(configuration.eval, expected);
  EXPECT_EQ(configuration.unit.tmus, 2);
  EXPECT_FALSE(configuration.unit.counters);
  EXPECT_FALSE(configuration.unit.duplicate_lines) << "it is one of the counters";
  EXPECT_EQ(std::get<pipeline::DramMemory>(configuration.memory).tRCD, 11U);
  ASSERT_TRUE(configuration.find_named("guard"));
  EXPECT_EQ(configuration.find_named("guard")->text, "7");
  EXPECT_FALSE(configuration.find_named("ways"));
}

TEST(Configuration, RefusesWhatCannotBuildNamingTheParameter) {
  using Kind = Setting::Kind;
  EXPECT_EQ(complaint({told("guard", "13")}), "--set guard=13|guard = 13|an integer from 0 to 12");
  EXPECT_EQ(complaint({told("guard", "13", Kind::number)}),
            "line 7 (hardware.guard)|13|an integer from 0 to 12");
  EXPECT_EQ(complaint({told("guard", "6", Kind::word)}),
            "line 7 (hardware.guard)|a string|an integer from 0 to 12");
  EXPECT_EQ(complaint({told("guard", "a number", Kind::other)}),
            "line 7 (hardware.guard)|a number|an integer from 0 to 12");
  EXPECT_EQ(complaint({told("counters", "1", Kind::number)}),
            "line 7 (hardware.counters)|an integer|true or false");
  EXPECT_EQ(complaint({told("rounding", "up")}),
            "--set rounding=up|rounding = up|one of truncate, nearest");
  EXPECT_EQ(complaint({told("guard", "99999999999")}),
            "--set guard=99999999999|guard = 99999999999|an integer from 0 to 12");
  EXPECT_EQ(complaint({told("guard", "6.5")}),
            "--set guard=6.5|guard = 6.5|an integer from 0 to 12");
  EXPECT_EQ(complaint({told("shift_groups", "4")}),
            "--set shift_groups=4|shift_groups = 4|one of 3, 6");
  EXPECT_EQ(complaint({told("basis_frac", "17")}),
            "--set basis_frac=17|basis_frac = 17|an integer from 4 to 16");
  EXPECT_EQ(complaint({told("cache_kib", "12", Kind::number)}),
            "line 7 (hardware.cache_kib)|12|one of 1, 2, 4, 8, 16, 32, 64");
  EXPECT_EQ(complaint({told("miss_fifo", "11", Kind::number)}),
            "line 7 (hardware.miss_fifo)|11|an integer from 12 to 256");
  EXPECT_EQ(complaint({told("tmus", "2"), told("miss_fifo", "9")}), "") << "8 are enough for two";
  EXPECT_EQ(complaint({told("stages", "128")}).rfind("--set stages=128|stages = 128|a part of", 0),
            0U);
  // What follows from a parameter that is not named is said of the table.
  EXPECT_EQ(complaint({told("preset", "wide"), told("light_frac", "6")}),
            "line 6 (hardware)|basis_frac = 16|an integer from 4 to 12");
  EXPECT_EQ(complaint({told("counters", "false"), told("duplicate_lines", "true")})
                .rfind("--set duplicate_lines=true|", 0),
            0U);
  EXPECT_EQ(
      complaint({told("coef_bits", "13")}).rfind("--set coef_bits=13|coef_bits = 13|an integer", 0),
      0U);
  EXPECT_EQ(complaint({told("preset", "huge", Kind::word)}),
            "line 7 (hardware.preset)|preset 'huge'|paper8, base or wide");
  const std::string unknown = complaint({told("colour", "3", Kind::number)});
  EXPECT_EQ(unknown.rfind("line 7|unknown key 'hardware.colour'|one of preset, coef_bits, ", 0), 0U)
      << unknown;
  EXPECT_EQ(complaint({}, {told("kind", "random"), told("latency", "3")}),
            "--set latency=3|unknown key 'latency'|one of kind, seed, latency_min, latency_max");
  EXPECT_EQ(complaint({}, {told("kind", "random"), told("latency_min", "300")}),
            "line 9 (memory)|latency_max = 200|an integer from 300 to 100000");
  EXPECT_EQ(
      complaint({}, {told("kind", "dram"), told("tREFI", "274")}),
      "--set tREFI=274|tREFI = 274|0, or more than tRFC + tRCD, which leaves time for a read");
  EXPECT_EQ(complaint({}, {told("kind", "disk")}),
            "--set kind=disk|'disk'|one of fixed, dram, random");
}

TEST(Configuration, OfAnEvaluatorAndOfAWholeUnitHaveTheWholeRange) {
  const Settings hardware{"", {told("coef_bits", "12")}}, memory;
  EXPECT_EQ(make_configuration({"scene.toml", hardware, memory}).eval.coef_bits, 12);
  EXPECT_EQ(make_unit_configuration({"scene.toml", hardware, memory}).eval.coef_bits, 12);
}

TEST(Configuration, WrittenAsTomlIsReadAsItWas) {
  std::mt19937_64 rng(5);
  for (int n = 0; n < 20; ++n) {
    const tests::ScratchFolder scratch;
    std::vector<Setting> hardware;
    for (const auto& [name, text] : tests::random_parameters(rng)) {
      hardware.push_back(told(name, text));
    }
    const Configuration before =
        made(hardware, n % 2 == 0 ? std::vector<Setting>{told("kind", "dram"), told("CL", "9")}
                                  : std::vector<Setting>{told("kind", "random"),
                                                         told("seed", "9223372036854775807")});
    const std::string text = configuration_toml(before);
    const auto path =
        scratch.write("scene.toml",
                      "[[texture]]\nname = \"m\"\ngenerate = \"relief\"\n[[object]]\n"
                      "kind = \"plane\"\ntexture = \"m\"\n[[light]]\ndirection = [0, -1, 1]\n" +
                          text);
    const golden::UnitScene scene = golden::read_unit_scene(path);
    const Configuration after =
        make_unit_configuration({path.string(), scene.hardware, scene.memory});
    EXPECT_EQ(after.eval, before.eval) << text;
    EXPECT_EQ(after.unit, before.unit) << text;
    EXPECT_EQ(configuration_toml(after), text);
  }
}

TEST(Configuration, IsCalledByItsPresetOrByWhatItChangesOfTheNearest) {
  EXPECT_EQ(name_of(reference::kBase), "base");
  EXPECT_EQ(name_of(reference::kPaper8), "paper8");
  EXPECT_EQ(name_of({.shift_groups = 3}), "base with shift_groups = 3");
  reference::EvalConfig config = reference::kWide;
  config.rounding = reference::Rounding::truncate;
  config.guard = 9;
  EXPECT_EQ(name_of(config), "wide with guard = 9, rounding = truncate");
}

}  // namespace
}  // namespace ptm::testbench
