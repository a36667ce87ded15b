// What differs between two runs: each kind is planted in a copy of the same made-up run.
#include <gtest/gtest.h>

#include <limits>

#include "golden/files/input_error.h"
#include "golden/files/picture_file.h"
#include "testbench/compare/run_verdict.h"
#include "testbench/report/level_picture.h"
#include "testbench/report/report.h"
#include "tests/report/made_unit.h"
#include "tests/scratch_folder.h"

namespace ptm::testbench {
namespace {

namespace fs = std::filesystem;
using Kind = DifferenceKind;

/// A unit's run whose models all say what a run's would: the same counters twice.
RunResult unit_run() {
  RunResult run = tests::made_unit_run(12, 9, 2);
  for (const char* name : {"pipeline", "rtl"}) {
    const std::size_t m = std::string(name) == "rtl" ? 3 : 2, t = m == 3 ? 2 : 0;
    const reference::UnitCounters& counters = run.unit->timings[t].counters;
    run.models[m].counters.clear();
    for (std::size_t n = 0; n + 1 < reference::kUnitCounters; ++n) {
      run.models[m].counters.push_back(
          {std::string(reference::unit_counter_names()[n]), counters.value[n]});
    }
    run.models[m].cycles = counters[reference::UnitCounter::cycles];
  }
  return run;
}

void set_counter(RunResult& run, const std::string& model, reference::UnitCounter counter,
                 std::uint64_t value) {
  const std::size_t m = model == "rtl" ? 3 : 2, t = m == 3 ? 2 : 0;
  run.unit->timings[t].counters[counter] = value;
  run.models[m].counters[static_cast<std::size_t>(counter)].value = value;
  if (counter == reference::UnitCounter::cycles) run.models[m].cycles = value;
}

class CompareRuns : public testing::Test {
 protected:
  CompareRuns() { write("a", unit_run()); }

  void write(const std::string& name, const RunResult& run) const {
    write_report(run, compare_run(run), folder_ / name);
  }
  [[nodiscard]] RunVerdict verdict(const std::string& tolerance = {}, const fs::path& a = "a",
                                   const fs::path& b = "b") const {
    Tolerance read;
    if (!tolerance.empty()) read = read_tolerance(folder_.write("tolerance.toml", tolerance));
    return compare_runs(read_run(folder_ / a.string()), read_run(folder_ / b.string()), read);
  }
  /// "kind path, path" of each, in order.
  static std::vector<std::string> lines(const RunVerdict& verdict) {
    std::vector<std::string> lines;
    for (const RunDifference& d : verdict.differences) {
      std::string line = std::string(kind_name(d.kind)) + " " + d.path;
      for (const std::string& path : d.also) line.append(", ").append(path);
      lines.push_back(line);
    }
    return lines;
  }
  static const RunDifference& find(const RunVerdict& verdict, const std::string& path) {
    for (const RunDifference& d : verdict.differences) {
      if (d.path == path) return d;
    }
    static const RunDifference none;
    ADD_FAILURE() << "nothing of " << path;
    return none;
  }
  /// A run that differs from the first in some levels of the RTL's second picture.
  void write_wrong_pixels() const {
    RunResult run = unit_run();
    write("b", run);
    golden::Image8 picture = level_picture(run.models[3].frames[1]);
    for (const auto& [x, y, by] : {std::array{3, 4, 1}, {7, 5, 3}, {8, 5, 2}}) {
      std::uint8_t& sample = picture.at(x, y, 1);
      sample = static_cast<std::uint8_t>(sample < 128 ? sample + by : sample - by);
    }
    golden::write_picture(folder_ / "b" / "rtl_01.png", picture);
  }
  /// Changes the text of b's report.
  void edit(const std::string& from, const std::string& to) const {
    const fs::path path = folder_ / "b/report.json";
    std::ifstream in(path);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    std::ofstream(path) << text;
  }
  void expect_refused(const std::string& place, const std::string& found) const {
    try {
      (void)verdict();
      ADD_FAILURE() << "not refused: " << found;
    } catch (const golden::InputError& error) {
      EXPECT_NE(error.place().find(place), std::string::npos) << error.what();
      EXPECT_NE(error.found().find(found), std::string::npos) << error.what();
    }
  }

  tests::ScratchFolder folder_;
};

using Lines = std::vector<std::string>;

TEST_F(CompareRuns, FindNothingBetweenARunAndItselfAtAnotherTimeAndPlace) {
  RunResult run = unit_run();
  run.made_by.date = "2031-01-01T00:00:00Z";
  run.made_by.invocation.commit = "unknown";
  for (ModelResult& model : run.models) model.seconds *= 7;
  write("b", run);
  EXPECT_EQ(lines(verdict()), Lines{});
  EXPECT_EQ(lines(verdict("", "a/report.json", "b")), Lines{});
}

TEST_F(CompareRuns, DoNotLookAtTheOrderInWhichAReportsMembersStand) {
  write("b", unit_run());
  std::ifstream in(folder_ / "b/report.json");
  const std::string sorted = nlohmann::json::parse(in).dump();
  folder_.write("b/report.json", sorted);
  EXPECT_EQ(lines(verdict()), Lines{});
}

TEST_F(CompareRuns, CountPixelsAndSayWhereTheWorstIs) {
  write_wrong_pixels();
  const RunVerdict found = verdict();
  EXPECT_EQ(lines(found), Lines{"pixels models.rtl.pictures"});
  const ModelPixels& pixels = *find(found, "models.rtl.pictures").pixels;
  EXPECT_EQ(pixels.pictures, 2U);
  EXPECT_EQ(pixels.samples, 2U * 12 * 9 * 3);
  EXPECT_EQ(pixels.differing, 3U);
  EXPECT_EQ(pixels.max, 3);
  ASSERT_EQ(pixels.files.size(), 1U);
  EXPECT_EQ(pixels.files[0].picture, "rtl_01.png");
  EXPECT_EQ(pixels.files[0].x, 7);
  EXPECT_EQ(pixels.files[0].y, 5);
  EXPECT_EQ(found.refused(), 1U);
}

TEST_F(CompareRuns, AllowPixelsByShareAndByLevels) {
  write_wrong_pixels();
  const double share = 3.0 / (2 * 12 * 9 * 3);
  const auto allowed = [&](const std::string& limits) {
    return verdict("[pixels]\n" + limits).refused() == 0;
  };
  EXPECT_TRUE(allowed("levels = 3\n"));
  EXPECT_FALSE(allowed("levels = 2.9\n"));
  EXPECT_TRUE(allowed("share = " + std::to_string(share + 1e-6) + "\n"));
  EXPECT_FALSE(allowed("share = " + std::to_string(share - 1e-6) + "\n"));
  EXPECT_FALSE(allowed("share = 1\nlevels = 2\n")) << "both must hold";
  EXPECT_FALSE(allowed(""));
  const std::string rule = "[[allow]]\npath = \"models.rtl.*\"\nlevels = 3\n";
  EXPECT_EQ(verdict(rule).refused(), 0U);
  EXPECT_EQ(
      verdict("[pixels]\nlevels = 255\n[[allow]]\npath = \"models.*\"\nlevels = 1\n").refused(), 1U)
      << "the rule of a path comes before the kind's";
}

TEST_F(CompareRuns, SayCyclesAndCountersOnceForModelsThatAgree) {
  RunResult run = unit_run();
  for (const char* model : {"pipeline", "rtl"}) {
    set_counter(run, model, reference::UnitCounter::cycles, 118000);
    set_counter(run, model, reference::UnitCounter::cycles_line_wait, 24888);
  }
  run.unit->timings[1].counters[reference::UnitCounter::cycles] = 119000;
  write("b", run);
  const RunVerdict found = verdict();
  EXPECT_EQ(lines(found), (Lines{"cycles models.pipeline.cycles, models.rtl.cycles",
                                 "cycles unit.timings.loose.counters.cycles",
                                 "counters models.pipeline.counters.cycles_line_wait, "
                                 "models.rtl.counters.cycles_line_wait"}));
  const RunDifference& cycles = find(found, "models.pipeline.cycles");
  EXPECT_EQ(*cycles.amount(), 578);
  EXPECT_EQ(*cycles.relative(), 578.0 / 117422);
  EXPECT_EQ(*find(found, "unit.timings.loose.counters.cycles").amount(), -300);
}

TEST_F(CompareRuns, AllowNumbersByAbsoluteAndRelativeLimitsAndDecrease) {
  RunResult run = unit_run();
  set_counter(run, "rtl", reference::UnitCounter::cycles, 117322);    // 100 fewer
  set_counter(run, "rtl", reference::UnitCounter::tag_misses, 3131);  // 1 % more
  write("b", run);
  const auto refused = [&](const std::string& tolerance) { return verdict(tolerance).refused(); };
  EXPECT_EQ(refused(""), 2U);
  EXPECT_EQ(refused("[cycles]\nabsolute = 100\n"), 1U);
  EXPECT_EQ(refused("[cycles]\nabsolute = 99\n"), 2U);
  EXPECT_EQ(refused("[cycles]\nrelative = 0.001\n"), 1U);
  EXPECT_EQ(refused("[cycles]\nrelative = 0.00085\n"), 2U) << "99.8 cycles";
  EXPECT_EQ(refused("[cycles]\nrelative = 0.0005\nabsolute = 42\n"), 1U) << "they add up";
  EXPECT_EQ(refused("[cycles]\ndecrease = true\n"), 1U);
  EXPECT_EQ(refused("[counters]\ndecrease = true\n"), 2U) << "more misses are no decrease";
  EXPECT_EQ(refused("[counters]\nrelative = 0.0101\n[cycles]\ndecrease = true\n"), 0U);
  EXPECT_EQ(refused("[[allow]]\npath = \"*tag_misses\"\nabsolute = 31\n"), 1U);
  EXPECT_EQ(refused("ignore = [\"models.rtl.c*\"]\n"), 0U);
  EXPECT_EQ(verdict("[cycles]\ndecrease = true\n").allowed(), 1U);
}

TEST_F(CompareRuns, NameTheParameterThatDiffersBeforeAllThatFollowsFromIt) {
  RunResult run = unit_run();
  run.config.unit->unit.cache_kib = 8;
  run.config.evaluator.guard = 6;
  run.config.unit->memory = pipeline::FixedMemory{.latency = 120};
  run.unit->memory = "fixed latency of 120 cycles, a line every 4";
  set_counter(run, "rtl", reference::UnitCounter::tag_misses, 6200);
  write("b", run);
  EXPECT_EQ(
      lines(verdict("[counters]\nrelative = 9\n")),
      (Lines{"configuration config.evaluator.guard", "configuration config.unit.cache_kib",
             "configuration config.memory.latency", "counters models.rtl.counters.tag_misses"}));
  EXPECT_EQ(verdict("ignore = [\"config.*\", \"*tag_misses\"]\n").refused(), 0U);
}

TEST_F(CompareRuns, FindFiguresThatDifferWhereNoPictureDoes) {
  RunResult run = unit_run();
  for (golden::ImageReal& frame : run.models[0].frames) {
    for (double& sample : frame.samples) {
      const double moved = sample + 1e-4;
      if (level8(moved) == level8(sample)) sample = std::min(moved, 255.0);
    }
  }
  write("b", run);
  const RunVerdict found = verdict();
  for (const RunDifference& d : found.differences) {
    EXPECT_TRUE(d.kind == Kind::figures || d.kind == Kind::lists) << d.path;
  }
  const RunDifference& mean = find(found, "differences[golden-reference].mean");
  EXPECT_EQ(mean.also, (Lines{"differences[golden-pipeline].mean", "differences[golden-rtl].mean",
                              "presets[base].mean"}));
  EXPECT_EQ(verdict("lists = true\n[figures]\nabsolute = 0.01\n").refused(), 0U);
  EXPECT_GT(verdict("[figures]\nabsolute = 0.01\n").refused(), 0U) << "the lists differ";
  EXPECT_GT(verdict("lists = true\n").refused(), 0U) << "the figures differ";
}

TEST_F(CompareRuns, FindModelsThatNoLongerAgree) {
  RunResult run = unit_run();
  run.unit->late_pixels = 4;
  write("b", run);
  edit("\"agree\": true", "\"agree\": false");
  EXPECT_EQ(lines(verdict()), (Lines{"agreement agree", "agreement unit.late_pixels"}));
}

TEST_F(CompareRuns, SayOnceThatAModelOrASectionIsInOneRunOnly) {
  RunResult run = unit_run();
  run.models.erase(run.models.begin() + 2);                                           // pipeline
  run.unit->timings.erase(run.unit->timings.begin(), run.unit->timings.begin() + 2);  // and loose
  write("b", run);
  EXPECT_EQ(lines(verdict()), Lines{"structure models.pipeline"});
  EXPECT_EQ(find(verdict(), "models.pipeline").only, "A");
  EXPECT_EQ(find(verdict("", "b", "a"), "models.pipeline").only, "B");
  EXPECT_EQ(verdict("ignore = [\"models.pipeline\"]\n").refused(), 0U);
  run = unit_run();
  run.unit.reset();
  run.notes = {"another"};
  write("b", run);
  EXPECT_EQ(lines(verdict()), (Lines{"structure unit", "notes notes"}));
}

TEST_F(CompareRuns, FindPicturesThatAreMissingOrOfAnotherSizeOrNumber) {
  write("b", unit_run());
  fs::remove(folder_ / "b/rtl_01.png");
  golden::write_picture(folder_ / "b/golden_00.png", golden::Image8(12, 8, 3));
  const RunVerdict found = verdict("[pixels]\nlevels = 255\n");
  EXPECT_EQ(lines(found), (Lines{"structure models.rtl.pictures[rtl_01.png]",
                                 "pixels models.golden.pictures[golden_00.png]"}));
  EXPECT_EQ(found.refused(), 2U) << "no limit in levels allows another size";
  EXPECT_EQ(find(found, "models.rtl.pictures[rtl_01.png]").only, "A");
  EXPECT_EQ(find(found, "models.golden.pictures[golden_00.png]").b, "12 x 8 pixels, 3 channels");
  RunResult run = unit_run();
  run.models[1].frames.pop_back();
  write("c", tests::made_unit_run(12, 9, 1));
  EXPECT_EQ(find(verdict("", "a", "c"), "models.golden.pictures").b, 1);
}

TEST_F(CompareRuns, CompareDigestsWhereAReportStandsForItsPictures) {
  RunResult run = unit_run();
  double& sample = run.models[3].frames[1].at(2, 2, 0);
  sample += sample < 128 ? 1 : -1;
  write("b", run);
  fs::create_directories(folder_ / "kept");
  fs::copy_file(folder_ / "a/report.json", folder_ / "kept/report.json");
  const RunVerdict found = verdict("", "kept/report.json", "b");
  EXPECT_TRUE(found.by_digests);
  EXPECT_EQ(find(found, "models.rtl.pictures").what,
            "1 of 2 differ by their digests; by how much is not known");
  EXPECT_EQ(verdict("", "kept/report.json", "a").differences.size(), 0U);
  // A folder is to hold its pictures.
  EXPECT_EQ(verdict("", "kept", "a").differences.at(0).also.size(), 7U);
  EXPECT_EQ(verdict("", "kept", "a").differences.at(0).kind, Kind::structure);
}

TEST_F(CompareRuns, PutTheWeightiestFirst) {
  RunResult run = unit_run();
  set_counter(run, "rtl", reference::UnitCounter::tag_misses, 3110);
  set_counter(run, "rtl", reference::UnitCounter::lines_read, 6200);
  set_counter(run, "rtl", reference::UnitCounter::cycles, 117423);
  run.notes = {"a note"};
  run.preset = "wide";
  write("b", run);
  EXPECT_EQ(lines(verdict()), (Lines{"configuration scene.preset", "cycles models.rtl.cycles",
                                     "counters models.rtl.counters.lines_read",
                                     "counters models.rtl.counters.tag_misses", "notes notes"}));
  EXPECT_EQ(lines(verdict("ignore = [\"scene.*\"]\n")).back(), "configuration scene.preset")
      << "what is allowed comes last";
}

TEST_F(CompareRuns, RefuseReportsOfAnotherVersionNamingBoth) {
  write("b", unit_run());
  edit("\"version\": 2", "\"version\": 1");
  try {
    (void)verdict();
    FAIL();
  } catch (const golden::InputError& error) {
    EXPECT_EQ(error.file(), (folder_ / "b/report.json").string());
    EXPECT_EQ(error.found(), "a report of version 1");
    EXPECT_NE(error.expected().find("version 2"), std::string::npos);
    EXPECT_NE(error.expected().find((folder_ / "a/report.json").string() + " has version 2"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(CompareRuns, RefuseWhatIsNoReportNamingThePlace) {
  const auto fresh = [&] { write("b", unit_run()); };
  fresh();
  edit("\"config\": {", "\"config\": [");
  expect_refused("line 28, column ", "no JSON");
  folder_.write("b/report.json", std::string(100, '[') + std::string(100, ']'));
  expect_refused("the file", "levels of nesting");
  folder_.write("b/report.json", "[1e999]");
  expect_refused("", "");
  folder_.write("b/report.json", "[]");
  expect_refused("the file", "a JSON array");
  folder_.write("b/report.json", "{}");
  expect_refused("version", "nothing");
  fresh();
  edit("\"models\": {", "\"moduls\": {");
  expect_refused("models", "nothing");
  fresh();
  edit("\"golden_00.png\",\n        \"golden_01.png\"", "\"../golden_00.png\", \"golden_01.png\"");
  expect_refused("models.golden.pictures", "../golden_00.png");
  fresh();
  edit("\"golden_00.png\",\n        \"golden_01.png\"", "\"golden_00.png\"");
  expect_refused("models.golden.digests", "2");
  fs::remove(folder_ / "b/report.json");
  expect_refused("report.json", "no such file");
  fs::remove_all(folder_ / "b");
  expect_refused("folder or file", "nothing there");
}

TEST_F(CompareRuns, RefuseToleranceFilesThatMeanNothingNamingTheLine) {
  write("b", unit_run());
  for (const auto& [text, place] : std::vector<std::pair<std::string, std::string>>{
           {"ignored = []\n", "line 1"},
           {"\nignore = \"notes\"\n", "line 2 (ignore)"},
           {"ignore = [1]\n", "line 1 (ignore[0])"},
           {"[pixels]\nabsolute = 1\n", "line 2"},
           {"[pixels]\nshare = 1.5\n", "line 2 (pixels.share)"},
           {"[cycles]\nrelative = -1\n", "line 2 (cycles.relative)"},
           {"[cycles]\nrelative = nan\n", "line 2 (cycles.relative)"},
           {"[counters]\ndecrease = 1\n", "line 2 (counters.decrease)"},
           {"[[allow]]\nabsolute = 1\n", "allow[0]"},
           {"[[allow]]\npath = \"x\"\nmax = 1\n", "line 3"},
           {"cycles = 3\n", "line 1 (cycles)"},
           {"= 3\n", "line 1"}}) {
    try {
      (void)verdict(text);
      ADD_FAILURE() << text;
    } catch (const golden::InputError& error) {
      EXPECT_NE(error.place().find(place), std::string::npos) << error.what();
    }
  }
}

TEST(ToleranceOfPaths, StarsStandForAnyCharacters) {
  EXPECT_TRUE(fits("a.b", "a.b"));
  EXPECT_FALSE(fits("a.b", "a.bc"));
  EXPECT_TRUE(fits("*", ""));
  EXPECT_TRUE(fits("a*c*e", "abcde"));
  EXPECT_FALSE(fits("a*c*f", "abcde"));
  EXPECT_TRUE(fits("differences[*-rtl].*", "differences[golden-rtl].rmse"));
  EXPECT_TRUE(fits("*ab", "aab"));
  EXPECT_FALSE(fits("", "a"));
}

}  // namespace
}  // namespace ptm::testbench
