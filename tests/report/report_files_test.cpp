#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "golden/files/input_error.h"
#include "testbench/report/report.h"
#include "testbench/report/report_json.h"
#include "testbench/report/staged_files.h"
#include "tests/report/made_unit.h"

namespace ptm::testbench {
namespace {

namespace fs = std::filesystem;
using tests::made_run;

/// A folder of this test's own, empty, and gone afterwards.
class ReportFiles : public testing::Test {
 protected:
  ReportFiles()
      : folder_(fs::path(testing::TempDir()) /
                ("ptm_report_" +
                 std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    fs::remove_all(folder_);
  }
  ~ReportFiles() override { fs::remove_all(folder_); }
  [[nodiscard]] std::set<std::string> names() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) names.insert(entry.path().filename());
    return names;
  }
  fs::path folder_;
};

nlohmann::json read_json(const fs::path& path) {
  std::ifstream in(path);
  return nlohmann::json::parse(in);
}

TEST_F(ReportFiles, OfOneLightAreAPictureAModelAndTheTwoReports) {
  const RunResult run = made_run(9, 7, 1);
  write_report(run, compare_run(run), folder_ / "made" / "if_missing");
  folder_ = folder_ / "made" / "if_missing";
  const std::set<std::string> expected = {"golden.png",  "pipeline.png", "reference.png",
                                          "report.html", "report.json",  "rtl.png"};
  EXPECT_EQ(names(), expected);
  folder_ = folder_.parent_path().parent_path();
}

TEST_F(ReportFiles, OfSeveralLightsAreNumberedAndListedInTheJson) {
  const RunResult run = made_run(5, 4, 11);
  const ReportPaths paths = write_report(run, compare_run(run), folder_);
  EXPECT_EQ(names().size(), 4U * 11 + 2);
  const nlohmann::json json = read_json(paths.json);
  EXPECT_EQ(json["models"]["rtl"]["picture"], "rtl_00.png");
  EXPECT_EQ(json["models"]["rtl"]["pictures"][10], "rtl_10.png");
  for (const auto& [name, model] : json["models"].items()) {
    for (const std::string picture : model["pictures"]) EXPECT_TRUE(names().contains(picture));
  }
}

TEST_F(ReportFiles, HoldInJsonWhatWasMeasured) {
  const RunResult run = tests::made_faulty_run(20, 15, 2);
  const RunComparison comparison = compare_run(run);
  const nlohmann::json json = read_json(write_report(run, comparison, folder_).json);
  EXPECT_EQ(json["models"]["pipeline"]["cycles"], 20 * 15 * 2 + 11);
  EXPECT_TRUE(json["models"]["golden"]["cycles"].is_null());
  EXPECT_EQ(json["models"]["rtl"]["counters"]["stall_cycles"], 5);
  EXPECT_EQ(json["timing"]["models"]["golden"], 0.0412);
  EXPECT_FALSE(json["agree"]);
  ASSERT_EQ(json["differences"].size(), 6U);
  const nlohmann::json& equal = json["differences"][3];
  EXPECT_EQ(equal["a"], "reference");
  EXPECT_EQ(equal["b"], "pipeline");
  EXPECT_EQ(equal["differing"], 0);
  EXPECT_TRUE(equal["psnr_db"].is_null());
  const nlohmann::json& wrong = json["differences"][4];
  EXPECT_EQ(wrong["differing"], 3);
  EXPECT_EQ(wrong["max"], 3);
  EXPECT_EQ(wrong["samples"], 20 * 15 * 3 * 2);
  EXPECT_EQ(wrong["psnr_db"], comparison.pairs[4].difference.psnr_db);
  EXPECT_EQ(json["worst"][0]["error"], 3);
  EXPECT_EQ(json["worst"][0]["frame"], 1);
  EXPECT_EQ(json["worst"][0]["pair"], (nlohmann::json{"reference", "rtl"}));
  EXPECT_EQ(json["worst"][0]["models"]["rtl"]["values"]["acc"], "1");
  EXPECT_EQ(json["presets"][1]["preset"], "base");
  EXPECT_EQ(json["notes"], run.notes);
}

TEST_F(ReportFiles, LeaveOutOfJsonTheCountersThatTheUnitIsBuiltWithout) {
  RunResult run = tests::made_unit_without_counters(8, 8, true);
  nlohmann::json report;
  const auto unit = [&] {
    report = read_json(write_report(run, compare_run(run), folder_).json);
    return report["unit"];
  };
  nlohmann::json json = unit();
  EXPECT_EQ(report["config"]["unit"]["counters"], true);
  EXPECT_EQ(report["config"]["unit"]["duplicate_lines"], false);
  const nlohmann::json& rtl = json["timings"]["rtl"]["counters"];
  EXPECT_EQ(rtl.size(), reference::kUnitCounters - 2) << "nor is there a row for effects";
  EXPECT_FALSE(rtl.contains("duplicate_lines"));
  EXPECT_EQ(rtl["lines_read"], 3100);
  run = tests::made_unit_without_counters(8, 8, false);
  json = unit();
  EXPECT_EQ(report["config"]["unit"]["counters"], false);
  EXPECT_TRUE(json["timings"]["rtl"]["counters"].empty());
  EXPECT_TRUE(json["timings"]["pipeline"]["counters"].empty());
  EXPECT_EQ(json["timings"]["loose"]["counters"]["cycles"], 119300) << "an estimate, no counter";
}

TEST_F(ReportFiles, HoldInJsonEveryCounterOfTheWholeUnit) {
  const RunResult run = tests::made_late_run(8, 8);
  const nlohmann::json report = read_json(write_report(run, compare_run(run), folder_).json);
  EXPECT_EQ(report["config"]["unit"]["fragment_fifo"], 192);
  const nlohmann::json& json = report["unit"];
  EXPECT_EQ(json["memory"], run.unit->memory);
  EXPECT_EQ(json["draws"][0]["color"], "grass.png");
  EXPECT_TRUE(json["draws"][1]["color"].is_null());
  EXPECT_EQ(json["draws"][0]["cycles_per_pixel"], 2);
  EXPECT_EQ(json["timings"].size(), 3U);
  const nlohmann::json& rtl = json["timings"]["rtl"];
  EXPECT_EQ(rtl["counters"].size(), reference::kUnitCounters - 1) << "no effects, no row for them";
  EXPECT_EQ(rtl["counters"]["cycles"], 117422);
  EXPECT_EQ(rtl["counters"]["multiplies_combine"], 98304);
  EXPECT_EQ(rtl["counters"]["misses_d1_map"], 900);
  EXPECT_EQ(report["timing"]["unit"]["rtl"], 0.1526);
  EXPECT_EQ(json["timings"]["pipeline"]["lines_per_window"].size(), 1836U);
  EXPECT_TRUE(json["timings"]["loose"]["lines_per_window"].empty());
  EXPECT_EQ(json["timings"]["loose"]["counters"].size(), 5U);
  EXPECT_EQ(json["timings"]["loose"]["counters"]["beats"], 90000);
  EXPECT_EQ(json["late_pixels"], 2);
  EXPECT_EQ(json["differing_counters"], run.unit->differing_counters);
}

TEST_F(ReportFiles, SayNothingOfTheUnitForAFlatScene) {
  const RunResult run = made_run(5, 4, 1);
  const nlohmann::json json = read_json(write_report(run, compare_run(run), folder_).json);
  EXPECT_FALSE(json.contains("unit"));
  EXPECT_EQ(json["config"]["unit"], (nlohmann::json{{"tmus", 3}}));
  EXPECT_FALSE(json["config"].contains("memory"));
}

TEST_F(ReportFiles, HoldInJsonEveryParameterOfTheConfiguration) {
  RunResult run = tests::made_unit_run(5, 4, 1);
  run.config.evaluator = reference::kPaper8;
  run.config.evaluator.shift_groups = 3;
  UnitRunConfig& unit = *run.config.unit;
  unit.unit.eval_lanes = 3;
  unit.unit.extra_passes = 2;
  unit.unit.half_vector = true;
  unit.unit.stages = 5;
  unit.memory = pipeline::DramMemory{.banks = 4, .tRCD = 17};
  unit.stress = {3, 4, 99};
  unit.frames = {golden::Traversal::scan, 8, true, true};
  const auto config = [&] {
    return read_json(write_report(run, compare_run(run), folder_).json)["config"];
  };
  nlohmann::json json = config();
  EXPECT_EQ(json["evaluator"]["rounding"], "truncate");
  EXPECT_EQ(json["evaluator"]["shift_groups"], 3);
  EXPECT_EQ(json["evaluator"].size(), 12U);
  EXPECT_EQ(json["unit"]["eval_lanes"], 3);
  EXPECT_EQ(json["effects"]["half_vector"], true);
  EXPECT_EQ(json["effects"]["extra_passes"], 2);
  EXPECT_EQ(json["effects"]["stages"], (nlohmann::json{"power", "add"}));
  EXPECT_EQ(json["memory"]["kind"], "dram");
  EXPECT_EQ(json["memory"]["tRCD"], 17);
  EXPECT_EQ(json["memory"].size(), 11U);
  EXPECT_EQ(json["stress"]["seed"], 99);
  EXPECT_FALSE(report_json(tests::made_unit_run(5, 4, 1), {})["config"].contains("effects"))
      << "a unit without parts for effects says nothing of them";
  EXPECT_EQ(json["frames"]["traversal"], "scan");
  EXPECT_EQ(json["frames"]["draw_twice"], true);
  unit.memory = pipeline::RandomMemory{.seed = 5, .latency_min = 1, .latency_max = 77};
  json = config();
  EXPECT_EQ(
      json["memory"],
      (nlohmann::json{{"kind", "random"}, {"seed", 5}, {"latency_min", 1}, {"latency_max", 77}}));
}

TEST_F(ReportFiles, DifferInNothingButWhatMadeThemAndTheTimes) {
  RunResult run = tests::made_late_run(9, 7);
  const auto rest = [&] {
    nlohmann::ordered_json json = report_json(run, compare_run(run));
    json.erase("made_by");
    json.erase("timing");
    return json.dump();
  };
  const std::string before = rest();
  run.made_by = {
      {"9.9", "unknown", {}, {"ptmsim"}}, "2027-01-01T00:00:00Z", "a", "b", "c", "d", "e", "f", 64};
  for (ModelResult& model : run.models) model.seconds *= 3;
  for (UnitTiming& timing : run.unit->timings) timing.seconds *= 5;
  EXPECT_EQ(rest(), before);
  EXPECT_EQ(before.find("seconds"), std::string::npos);
}

TEST_F(ReportFiles, HoldADigestOfEveryPictureThatTellsItFromOthers) {
  RunResult run = made_run(6, 5, 2);
  const auto digests = [&](const char* model) {
    return report_json(run, compare_run(run))["models"][model]["digests"];
  };
  const auto before = digests("rtl");
  ASSERT_EQ(before.size(), 2U);
  EXPECT_NE(before[0], before[1]) << "other lights, other pictures";
  EXPECT_EQ(digests("reference"), before);
  double& sample = run.models[3].frames[1].at(5, 4, 2);
  sample += sample < 128 ? 1 : -1;
  EXPECT_EQ(digests("rtl")[0], before[0]);
  EXPECT_NE(digests("rtl")[1], before[1]);
  golden::ImageReal wide(4, 1, 1), high(1, 4, 1);
  EXPECT_NE(picture_digest(wide), picture_digest(high));
}

TEST_F(ReportFiles, ReplaceAnEarlierReportAndLeaveNoTemporaryFile) {
  RunResult run = made_run(6, 6, 1);
  write_report(run, compare_run(run), folder_);
  run.scene_file = "second.toml";
  const ReportPaths paths = write_report(run, compare_run(run), folder_);
  EXPECT_EQ(read_json(paths.json)["scene"]["file"], "second.toml");
  EXPECT_EQ(names().size(), 6U);
}

TEST_F(ReportFiles, AppearTogetherOrNotAtAll) {
  {
    StagedFiles files(folder_);
    files.write("a.txt", std::string_view("half"));
    EXPECT_FALSE(fs::exists(folder_ / "a.txt"));
  }
  EXPECT_FALSE(fs::exists(folder_)) << "it was made for them";
  fs::create_directories(folder_);
  { StagedFiles(folder_).write("a.txt", std::string_view("half")); }
  EXPECT_TRUE(names().empty());
}

TEST_F(ReportFiles, AreRefusedWhereNoDirectoryCanBe) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "file") << "in the way";
  const RunResult run = made_run(3, 3, 1);
  EXPECT_THROW(write_report(run, compare_run(run), folder_ / "file"), golden::InputError);
  EXPECT_THROW(write_report(run, compare_run(run), folder_ / "file" / "below"), golden::InputError);
}

TEST_F(ReportFiles, SurviveNamesThatAreNotUtf8) {
  RunResult run = made_run(3, 3, 1);
  run.scene_file = "caf\xE9.toml";
  const ReportPaths paths = write_report(run, compare_run(run), folder_);
  EXPECT_EQ(read_json(paths.json)["scene"]["file"], "caf\xEF\xBF\xBD.toml");
}

TEST(PictureName, HasAsManyDigitsAsTheLastFrameNeeds) {
  EXPECT_EQ(picture_name("rtl", 0, 1), "rtl.png");
  EXPECT_EQ(picture_name("rtl", 0, 2), "rtl_00.png");
  EXPECT_EQ(picture_name("rtl", 99, 100), "rtl_99.png");
  EXPECT_EQ(picture_name("rtl", 7, 101), "rtl_007.png");
}

}  // namespace
}  // namespace ptm::testbench
