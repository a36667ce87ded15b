#include "golden/files/light_positions.h"

#include <cmath>

#include "tests/scratch_folder.h"
#include "tests/shared_data.h"

namespace ptm::golden {
namespace {

using tests::ScratchFolder;

/// The error that reading this text gives, with empty files a.png, b.png and "c d.png" beside it.
std::string error_of(const ScratchFolder& folder, const std::string& text) {
  for (const char* name : {"a.png", "b.png", "c d.png"}) folder.write(name, "x");
  try {
    (void)read_light_positions(folder.write("capture.lp", text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

LightPositions read(const ScratchFolder& folder, const std::string& text) {
  for (const char* name : {"a.png", "b.png", "c d.png"}) folder.write(name, "x");
  return read_light_positions(folder.write("capture.lp", text));
}

TEST(LightPositions, ReadsPicturesAndDirectionsInOrder) {
  const ScratchFolder folder;
  const LightPositions p = read(folder, "2\na.png 0.6 0 0.8\nb.png 0 -0.6 0.8\n");
  ASSERT_EQ(p.pictures.size(), 2U);
  EXPECT_EQ(p.pictures[0].picture, folder / "a.png");
  EXPECT_EQ(p.pictures[0].direction, (std::array<double, 3>{0.6, 0, 0.8}));
  EXPECT_EQ(p.pictures[0].line, 2);
  EXPECT_EQ(p.pictures[1].picture, folder / "b.png");
  EXPECT_EQ(p.pictures[1].direction[1], -0.6);
  EXPECT_TRUE(p.notes.empty());
}

TEST(LightPositions, TakesEveryHabitOfRealFiles) {
  const ScratchFolder folder;
  const std::string habits[] = {
      "a.png 0.6 0 0.8\nb.png 0 -0.6 0.8\n",                   // no count
      "2 \r\na.png 0.6 0 0.8 \r\n\r\nb.png\t0  -0.6 0.8\r\n",  // CRLF, tab, blanks, blank line
      "\xEF\xBB\xBF"
      "2\na.png 0.6 0 0.8\nb.png 0 -0.6 0.8",              // byte order mark, no last line end
      "\n\n2\n a.png +0.6 0 .8\nb.png 0 -6e-1 0.8\n\n\n",  // leading blank lines, number forms
      "2\njpg/a.png 0.6 0 0.8\nC:\\photos\\b.png 0 -0.6 0.8\n",  // folders that are not here
  };
  for (const std::string& text : habits) {
    const LightPositions p = read(folder, text);
    ASSERT_EQ(p.pictures.size(), 2U) << text;
    EXPECT_EQ(p.pictures[0].picture, folder / "a.png") << text;
    EXPECT_EQ(p.pictures[1].picture, folder / "b.png") << text;
    EXPECT_DOUBLE_EQ(p.pictures[1].direction[1], -0.6) << text;
    EXPECT_TRUE(p.notes.empty()) << text;
  }
}

TEST(LightPositions, PrefersThePictureWhereTheListSaysItIs) {
  const ScratchFolder folder;
  folder.write("jpg/a.png", "x");
  EXPECT_EQ(read(folder, "jpg/a.png 0 0 1\n").pictures[0].picture, folder / "jpg/a.png");
}

TEST(LightPositions, TakesBlanksWithinAPicturesName) {
  const ScratchFolder folder;
  EXPECT_EQ(read(folder, "c d.png 0 0 1\n").pictures[0].picture, folder / "c d.png");
}

TEST(LightPositions, NormalisesLightsAndSaysSo) {
  const ScratchFolder folder;
  const LightPositions p = read(folder, "a.png 1.2 0 1.6\nb.png 0 0 1\n");
  EXPECT_EQ(p.pictures[0].direction, (std::array<double, 3>{0.6, 0, 0.8}));
  ASSERT_EQ(p.notes.size(), 1U);
  EXPECT_EQ(p.notes[0], "1 of 2 lights were not of length 1 (2 to 2), normalised");
}

TEST(LightPositions, SaysWhenTheCountIsWrong) {
  const ScratchFolder folder;
  const LightPositions p = read(folder, "3\na.png 0 0 1\n");
  ASSERT_EQ(p.notes.size(), 1U);
  EXPECT_EQ(p.notes[0], "the first line says 3 lights, the file has 1");
}

TEST(LightPositions, LeavesOutLightsBelowTheHorizonWithANote) {
  const ScratchFolder folder;
  const LightPositions p = read(folder, "a.png 0.6 0 -0.8\nb.png 1 0 0\n");
  ASSERT_EQ(p.pictures.size(), 1U);
  EXPECT_EQ(p.pictures[0].picture, folder / "b.png");
  ASSERT_EQ(p.notes.size(), 1U);
  EXPECT_EQ(p.notes[0], "line 1: light below the horizon, left out");
}

TEST(LightPositions, NamesFileAndLineOfWhateverIsWrong) {
  const ScratchFolder folder;
  const std::pair<std::string, std::string> cases[] = {
      {"a.png 0 0 1\n\nz.png 0 0 1\n", "line 3: found no picture 'z.png'"},
      {"1\na.png 0 0 0\n", "line 2: found light (0, 0, 0)"},
      {"1\na.png 0 nan 1\n", "line 2: found coordinate 'nan'"},
      {"1\na.png 0 inf 1\n", "line 2: found coordinate 'inf'"},
      {"1\na.png 0 1e999 1\n", "line 2: found coordinate '1e999'"},
      {"1\na.png 0 0.5x 1\n", "line 2: found coordinate '0.5x'"},
      {"1\na.png 0 +-1 1\n", "line 2: found coordinate '+-1'"},
      {"1\na.png 0 1\n", "line 2: found 'a.png 0 1'"},
      {"1\n0 0 1\n", "line 2: found '0 0 1'"},
      {"1\na.png 1.7e308 1e308 1e308\n", "line 2: found a light of endless length"},
      {"1\n2\n", "line 2: found '2'"},
      {"", "file: found no light"},
      {"0\n", "file: found no light"},
      {"a.png 0 0 -1\n", "file: found no light above the horizon"},
  };
  for (const auto& [text, message] : cases) {
    const std::string error = error_of(folder, text);
    EXPECT_NE(error.find(message), std::string::npos) << text << " gives " << error;
    EXPECT_NE(error.find("capture.lp"), std::string::npos);
  }
}

TEST(LightPositions, RefusesAFileThatIsNotThereAndAFolder) {
  const ScratchFolder folder;
  EXPECT_THROW((void)read_light_positions(folder / "none.lp"), InputError);
  EXPECT_THROW((void)read_light_positions(folder / ""), InputError);
}

TEST(LightPositions, WrittenListsAreReadBackToTheLastBit) {
  const ScratchFolder folder;
  folder.write("a.png", "x");
  const double u = 1 / std::sqrt(3.0);
  const std::vector<LitPicture> written{{folder / "a.png", {u, -u, u}, 0}};
  write_light_positions(folder / "capture.lp", written);
  const LightPositions p = read_light_positions(folder / "capture.lp");
  ASSERT_EQ(p.pictures.size(), 1U);
  EXPECT_EQ(p.pictures[0].picture, written[0].picture);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(p.pictures[0].direction[i], written[0].direction[i], 1e-15);
  }
}

TEST(LightPositions, NamesTheMissingPictureOfARealCapture) {
  PTM_SHARED_DATA_OR_SKIP(path, "hostile_lp/item12/dirs.lp");
  try {
    (void)read_light_positions(path);
    FAIL() << "image47.jpg is not there";
  } catch (const InputError& error) {
    EXPECT_NE(error.found().find("image47.jpg"), std::string::npos);
    EXPECT_EQ(error.place(), "line 49");
  }
}

TEST(LightPositions, ReadsARealCaptureWithLightsOfAllLengths) {
  PTM_SHARED_DATA_OR_SKIP(path, "hostile_lp/item11/dirs.lp");
  const LightPositions p = read_light_positions(path);
  EXPECT_EQ(p.pictures.size(), 54U);
  ASSERT_EQ(p.notes.size(), 1U);
  EXPECT_NE(p.notes[0].find("0.7952 to 1.06"), std::string::npos);
}

}  // namespace
}  // namespace ptm::golden
