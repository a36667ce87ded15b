// A command run again with less to write: what only the earlier run wrote goes, and nothing else.
#include "tests/faults/commands.h"

namespace ptm::tests {
namespace {

namespace fs = std::filesystem;

class Reruns : public Program {
 protected:
  Reruns() { golden::write_ptm(file("map.ptm"), small_map(golden::MapKind::lrgb, 16, 16)); }
};

using Names = std::vector<std::string>;

TEST_F(Reruns, RemovePicturesOfModelsAndLightsThatAreNoLongerThere) {
  write("two.toml", flat_scene("map.ptm", R"("golden", "reference")", 2));
  write("one.toml", flat_scene("map.ptm", R"("golden")", 1));
  const std::string out = " --out " + quoted(file("out"));
  ASSERT_EQ(run("run " + quoted(file("two.toml")) + out).code, 0);
  std::ofstream(file("out/mine.png")) << "a user's";
  std::ofstream(file("out/rtl_00.png")) << "a user's, of a name that the report does not list";
  ASSERT_EQ(run("run " + quoted(file("two.toml")) + out + " --models golden").code, 0);
  EXPECT_EQ(names_in(file("out")), (Names{"golden_00.png", "golden_01.png", "mine.png",
                                          "report.html", "report.json", "rtl_00.png"}));
  ASSERT_EQ(run("run " + quoted(file("one.toml")) + out).code, 0);
  EXPECT_EQ(names_in(file("out")),
            (Names{"golden.png", "mine.png", "report.html", "report.json", "rtl_00.png"}));
}

TEST_F(Reruns, RemoveNothingThatAnEditedReportNames) {
  write("one.toml", flat_scene("map.ptm", R"("golden")", 1));
  fs::create_directories(file("out"));
  write("above.png", "a user's");
  std::ofstream(file("out/report.json"))
      << R"({"models": {"../above": {"pictures": ["../above.png"]},
                        "reference": {"pictures": ["mine.png", 7]}, "rtl": [], "golden": 3}})";
  std::ofstream(file("out/mine.png")) << "a user's";
  ASSERT_EQ(run("run " + quoted(file("one.toml")) + " --out " + quoted(file("out"))).code, 0);
  EXPECT_TRUE(fs::exists(file("above.png")));
  EXPECT_TRUE(fs::exists(file("out/mine.png")));
}

TEST_F(Reruns, OfARunThatFailsKeepTheEarlierReportWithItsPictures) {
  write("two.toml", flat_scene("map.ptm", R"("golden", "reference")", 1));
  const std::string command = "run " + quoted(file("two.toml")) + " --out " + quoted(file("out"));
  ASSERT_EQ(run(command).code, 0);
  fs::remove(file("out/report.html"));
  fs::create_directories(file("out/report.html/in the way"));
  EXPECT_EQ(run(command + " --models golden").code, 3);
  EXPECT_TRUE(fs::exists(file("out/reference.png")));
}

TEST_F(Reruns, RemoveLevelsOfALargerMap) {
  golden::write_ptm(file("small.ptm"), small_map(golden::MapKind::lrgb, 3, 2));
  const std::string out = quoted(file("out/m.ptm"));
  fs::create_directories(file("out"));
  ASSERT_EQ(run("convert " + quoted(file("map.ptm")) + " " + out + " --mip").code, 0);
  EXPECT_EQ(names_in(file("out")).size(), 5U);
  golden::write_ptm(file("out/m.7.ptm"), small_map(golden::MapKind::lrgb, 4, 4));
  ASSERT_EQ(run("convert " + quoted(file("small.ptm")) + " " + out + " --mip").code, 0);
  EXPECT_EQ(names_in(file("out")), (Names{"m.0.ptm", "m.1.ptm", "m.7.ptm"}));
  // Not levels of one map: the first is not followed by its half.
  golden::write_ptm(file("out/m.2.ptm"), small_map(golden::MapKind::lrgb, 4, 4));
  golden::write_ptm(file("out/m.3.ptm"), small_map(golden::MapKind::lrgb, 1, 1));
  ASSERT_EQ(run("convert " + quoted(file("small.ptm")) + " " + out + " --mip").code, 0);
  EXPECT_EQ(names_in(file("out")).size(), 5U);
}

TEST_F(Reruns, RemovePhotographsThatTheListNoLongerNames) {
  const std::string command = "synthesize --size 16 --out " + quoted(file("out"));
  ASSERT_EQ(run(command + " --lights 4").code, 0);
  std::ofstream(file("out/photo_005.png")) << "a user's";
  ASSERT_EQ(run(command + " --lights 2").code, 0);
  EXPECT_EQ(names_in(file("out")),
            (Names{"capture.lp", "photo_001.png", "photo_002.png", "photo_005.png"}));
}

}  // namespace
}  // namespace ptm::tests
