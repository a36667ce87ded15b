#include "golden/files/light_table.h"

#include "golden/files/picture_folder.h"
#include "tests/scratch_folder.h"
#include "tests/shared_data.h"

namespace ptm::golden {
namespace {

using tests::ScratchFolder;

/// Empty files p1.png ... p<count>.png in a folder of their own.
std::filesystem::path pictures(const ScratchFolder& folder, int count) {
  for (int i = 1; i <= count; ++i) folder.write("p/p" + std::to_string(i) + ".png", "x");
  return folder / "p";
}

template <class Read>
std::string error_of(Read read) {
  try {
    (void)read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(LightTable, ReadsOneLightALineAndOneCoordinateALineAlike) {
  const ScratchFolder folder;
  const auto four = pictures(folder, 4);
  const auto rows = read_light_table(
      folder.write("rows.txt", "# x y z\n0.6 0 0.8\n0,0.6,0.8\n\n0\t0\t1\n-0.6 0 0.8\n"), four);
  const auto columns = read_light_table(
      folder.write("columns.txt", " 0.6 0 0 -0.6\n 0 0.6 0 0\n 0.8 0.8 1 0.8\n"), four);
  ASSERT_EQ(rows.pictures.size(), 4U);
  ASSERT_EQ(columns.pictures.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(rows.pictures[i].direction, columns.pictures[i].direction) << i;
    EXPECT_EQ(rows.pictures[i].picture, columns.pictures[i].picture) << i;
  }
  EXPECT_EQ(rows.pictures[3].direction[0], -0.6);
  EXPECT_EQ(rows.pictures[2].line, 5);
  EXPECT_TRUE(rows.notes.empty());
}

TEST(LightTable, TakesThreeTimesThreeNumbersAsOneLightALineAndSaysSo) {
  const ScratchFolder folder;
  const auto table =
      read_light_table(folder.write("t.txt", "1 0 0\n0 0.6 0.8\n0 0 1\n"), pictures(folder, 3));
  EXPECT_EQ(table.pictures[1].direction[1], 0.6);
  ASSERT_EQ(table.notes.size(), 1U);
}

TEST(LightTable, ReadsWhatSpreadsheetsAndProgramsWrite) {
  const ScratchFolder folder;
  const auto four = pictures(folder, 4);
  const std::pair<const char*, std::size_t> tables[] = {
      // The text, and how many notes it earns.
      {"4\n0.6 0 0.8\n0 0.6 0.8\n0 0 1\n-0.6 0 0.8\n", 0},
      {"4\r0.6 0 0.8\r0 0.6 0.8\r0 0 1\r-0.6 0 0.8\r", 0},
      {"4,,\r\n0.6,0,0.8\r\n0,0.6,0.8\r\n0,0,1\r\n-0.6,0,0.8\r\n", 0},
      {"x,y,z\n0.6,0,0.8\n0,0.6,0.8\n0,0,1\n-0.6,0,0.8\n", 1},
      {"\"Lx\";\"Ly\";\"Lz\"\n4\n0,6;0;0,8\n0;0,6;0,8\n0;0;1\n-0,6;0,0;0,8\n", 2},
      {"0,6 0,0 0,8\n0,0 0,6 0,8\n0,0 0,0 1,0\n-0,6 0,0 0,8\n", 1},
      {"4\n0,6\t0\t0\t-0,6\n0\t0,6\t0\t0\n0,8\t0,8\t1\t0,8\n", 1},
      {"z,y,x\n0.8,0,0.6\n0.8,0.6,0\n1,0,0\n0.8,0,-0.6\n", 1},
      {"lights of the dome\nno;x;y;z\n1;0.6;0;0.8\n2;0;0.6;0.8\n3;0;0;1\n4;-0.6;0;0.8\n", 2},
      {"% matlab\n// and others\n0.6 0 0.8\n0 0.6 0.8\n0 0 1\n-0.6 0 0.8\n", 0},
      {"4\n0.6 0 0.8\n0 0.6 0.8\n0 0 1\n-0.6 0 0.8\n1 1 1\n", 1},
  };
  for (const auto& [text, notes] : tables) {
    const auto table = read_light_table(folder.write("t.txt", text), four);
    ASSERT_EQ(table.pictures.size(), 4U) << text;
    EXPECT_EQ(table.pictures[0].direction, (std::array<double, 3>{0.6, 0, 0.8})) << text;
    EXPECT_EQ(table.pictures[1].direction, (std::array<double, 3>{0, 0.6, 0.8})) << text;
    EXPECT_EQ(table.pictures[3].direction, (std::array<double, 3>{-0.6, 0, 0.8})) << text;
    EXPECT_EQ(table.notes.size(), notes) << text;
  }
}

TEST(LightTable, TakesCommasForSeparatorsWhereTheyCanBeNothingElse) {
  const ScratchFolder folder;
  const auto four = pictures(folder, 4);
  const auto table = read_light_table(folder.write("t.csv", "1,0,0\n0,1,0\n0,0,1\n-1,0,0\n"), four);
  EXPECT_EQ(table.pictures[1].direction, (std::array<double, 3>{0, 1, 0}));
  EXPECT_TRUE(table.notes.empty());
}

TEST(LightTable, OrdersPicturesByTheNumbersInTheirNamesAndPassesOverOtherFiles) {
  EXPECT_TRUE(natural_less("p2.png", "p10.png"));
  EXPECT_FALSE(natural_less("p10.png", "p2.png"));
  EXPECT_TRUE(natural_less("p02.png", "p2.png"));  // equal numbers: some fixed order
  EXPECT_FALSE(natural_less("p2.png", "p02.png"));
  EXPECT_FALSE(natural_less("a", "a"));
  EXPECT_TRUE(natural_less("a", "a1"));
  const ScratchFolder folder;
  const auto ten = pictures(folder, 10);
  for (const char* name : {"p/readme.txt", "p/.p0.png", "p/lights.lp"}) folder.write(name, "x");
  std::string numbers;
  for (int i = 1; i <= 10; ++i) numbers += "0 0 1\n";
  const auto table = read_light_table(folder.write("t.txt", numbers), ten);
  EXPECT_EQ(table.pictures[1].picture.filename(), "p2.png");
  EXPECT_EQ(table.pictures[9].picture.filename(), "p10.png");
}

TEST(LightTable, NamesWhatIsWrongWithIt) {
  const ScratchFolder folder;
  const auto two = pictures(folder, 2);
  const std::pair<const char*, const char*> cases[] = {
      {"0 0 1\n0 nan 1\n", "line 2: found \"nan\""},
      {"0 0 1\n0 inf 1\n", "line 2: found \"inf\""},
      {"0 0 1\n0 1\n", "line 2: found 2 numbers, expected 3"},
      {"0 0 1 0\n0 1 0\n1 0 0 1\n", "line 2: found 3 numbers, expected 4"},
      {"0 0 1\n0 0 0\n", "light 2 (line 2): found light (0, 0, 0)"},
      {"0 0 1\n", "found 2 pictures, expected 1"},
      {"0 0 1\n0 0 1\n0 1 0\n1 0 0\n", "found 2 pictures, expected 4"},
      {"0 0 -1\n0 0 -1\n", "no light above the horizon"},
  };
  for (const auto& [text, message] : cases) {
    const auto table = folder.write("t.txt", text);
    const std::string error = error_of([&] { return read_light_table(table, two); });
    EXPECT_NE(error.find(message), std::string::npos) << text << " gives " << error;
  }
  EXPECT_NE(error_of([&] { return read_light_table(folder / "none", two); }).find("No such file"),
            std::string::npos);
}

TEST(ParameterTable, KeepsNumbersWithinOneAndStretchesOthers) {
  const ScratchFolder folder;
  const auto three = pictures(folder, 3);
  const auto kept = read_parameter_table(folder.write("k.txt", "-0.5\n0\n1\n"), three);
  EXPECT_EQ(kept.pictures[0].direction, (std::array<double, 3>{-0.5, 0, 0}));
  EXPECT_TRUE(kept.notes.empty());
  const auto stretched = read_parameter_table(folder.write("s.txt", "10 15 30\n"), three);
  EXPECT_DOUBLE_EQ(stretched.pictures[0].direction[0], -1);
  EXPECT_DOUBLE_EQ(stretched.pictures[1].direction[0], -0.5);
  EXPECT_DOUBLE_EQ(stretched.pictures[2].direction[0], 1);
  EXPECT_EQ(stretched.notes.size(), 1U);
  const auto two_a_line = folder.write("w.txt", "1 2\n3 4\n");
  EXPECT_NE(error_of([&] { return read_parameter_table(two_a_line, three); }).find("line 1"),
            std::string::npos);
}

TEST(ParameterTable, TakesACountAndDecimalCommas) {
  const ScratchFolder folder;
  const auto three = pictures(folder, 3);
  for (const char* text :
       {"3\n-0.5\n0\n1\n", "-0,5\n0\n1\n", "u\n-0.5\n0\n1\n", "-0,5 0 1\n", "3\n-0.5 0 1\n"}) {
    const auto table = read_parameter_table(folder.write("k.txt", text), three);
    ASSERT_EQ(table.pictures.size(), 3U) << text;
    EXPECT_EQ(table.pictures[0].direction[0], -0.5) << text;
    EXPECT_EQ(table.pictures[2].direction[0], 1) << text;
  }
  // Two more numbers than their own count: the first one is a number like the others.
  const auto stretched = read_parameter_table(folder.write("k.txt", "2\n1\n0\n"), three);
  EXPECT_EQ(stretched.pictures[0].direction[0], 1);
}

TEST(LightTable, ReadsARealTableOfThreeLines) {
  PTM_SHARED_DATA_OR_SKIP(folder, "psbox");
  const auto table = read_light_table(folder / "light_directions.txt", folder / "Objects");
  ASSERT_EQ(table.pictures.size(), 12U);
  EXPECT_EQ(table.pictures[11].picture.filename(), "Image_12.png");
  EXPECT_NEAR(table.pictures[1].direction[1], 0.3514, 1e-4);
}

}  // namespace
}  // namespace ptm::golden
