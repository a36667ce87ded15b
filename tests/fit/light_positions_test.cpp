#include "golden/files/light_positions.h"

#include <algorithm>
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

TEST(LightPositions, SaysThatPositionsAreTakenAsDirections) {
  const ScratchFolder folder;
  const std::string list = "a.png 0 0 300\nb.png 120 0 160\n";
  const LightPositions p = read(folder, list);
  EXPECT_EQ(p.pictures[1].direction, (std::array<double, 3>{0.6, 0, 0.8}));
  EXPECT_EQ(p.pictures[1].position, (std::array<double, 3>{120, 0, 160}));
  ASSERT_EQ(p.notes.size(), 1U);
  EXPECT_EQ(p.notes[0],
            "2 of 2 lights were not of length 1 (200 to 300), as positions are; they are taken as "
            "directions, as if all light came from afar: --width-mm WIDTH fits near lights");
  EXPECT_TRUE(
      read_light_positions(folder / "capture.lp", {.folder = {}, .positions = true}).notes.empty());
}

TEST(LightPositions, SaysWhenTheCountIsWrong) {
  const ScratchFolder folder;
  const LightPositions p = read(folder, "3\na.png 0 0 1\n");
  ASSERT_EQ(p.notes.size(), 1U);
  EXPECT_EQ(p.notes[0], "the first line says 3 lights, the file has 1");
}

TEST(LightPositions, ReadsNoLineBeyondTheCount) {
  const ScratchFolder folder;
  const LightPositions p =
      read(folder, "2\na.png 0 0 1\nb.png 0.6 0 0.8\nmissing.png 0 0.6 0.8\nno light\n");
  EXPECT_EQ(p.pictures.size(), 2U);
  ASSERT_EQ(p.notes.size(), 1U);
  EXPECT_EQ(p.notes[0],
            "the first line says 2 lights, the file has 4; what is beyond the count is not read");
}

TEST(LightPositions, ReadsTheNumbersThatSpreadsheetsWrite) {
  const ScratchFolder folder;
  const std::string lists[] = {
      "a.png 0,6 0 0,8\nb.png 0,0 -0,6 0,8\n",             // decimal commas
      "2;;;\r\na.png;0,6;0;0,8\r\nb.png;0;-0,6;,8e0\r\n",  // no digit before the comma: refused
      "a.png;0,6;0;0,8\nb.png;0,0;-0,6;0,8\n",
      "a.png\t0,6\t0,0\t0,8\nb.png\t0,0\t-6,0e-1\t0,8\n",
      "a.png, 0.6, 0, 0.8\nb.png, 0, -0.6, 0.8\n",
      "2,,,\nname,x,y,z\n\"a.png\",0.6,0,0.8\nb.png,0,-0.6,0.8,\n",
  };
  for (const std::string& text : lists) {
    if (text.find(",8e0") != std::string::npos) {
      EXPECT_NE(error_of(folder, text).find("line 3: found coordinate ',8e0'"), std::string::npos);
      continue;
    }
    const LightPositions p = read(folder, text);
    ASSERT_EQ(p.pictures.size(), 2U) << text;
    EXPECT_EQ(p.pictures[0].picture, folder / "a.png") << text;
    EXPECT_EQ(p.pictures[0].direction, (std::array<double, 3>{0.6, 0, 0.8})) << text;
    EXPECT_EQ(p.pictures[1].picture, folder / "b.png") << text;
    EXPECT_EQ(p.pictures[1].direction, (std::array<double, 3>{0, -0.6, 0.8})) << text;
  }
  const LightPositions commas = read(folder, "1\na.png 0,6 0 0,8\n");
  ASSERT_EQ(commas.notes.size(), 1U);
  EXPECT_EQ(commas.notes[0], "numbers with a decimal comma, the first in line 2");
}

TEST(LightPositions, ReadsEveryKindOfLineEndAndSixteenBitText) {
  const ScratchFolder folder;
  const std::string plain = "2\na.png 0.6 0 0.8\nb.png 0 -0.6 0.8\n";
  std::string old = plain, wide = "\xFF\xFE", big = "\xFE\xFF";
  std::replace(old.begin(), old.end(), '\n', '\r');
  for (const char c : plain) {
    wide += std::string{c, '\0'};
    big += std::string{'\0', c};
  }
  std::string marked = "\xEF\xBB\xBF";
  marked.append(old).append("\r\r");
  for (const std::string& text : {old, wide, big, marked}) {
    const LightPositions p = read(folder, text);
    ASSERT_EQ(p.pictures.size(), 2U);
    EXPECT_EQ(p.pictures[1].picture, folder / "b.png");
    EXPECT_EQ(p.pictures[1].line, 3);
    EXPECT_TRUE(p.notes.empty());
  }
}

TEST(LightPositions, TakesNamesOfAnotherCaseIfOneFileIsMeant) {
  const ScratchFolder folder;
  folder.write("Jpg/C.png", "x");
  const LightPositions p = read(folder, "A.PNG 0 0 1\njpg\\c.PNG 0.6 0 0.8\nb.png 0 0.6 0.8\n");
  ASSERT_EQ(p.pictures.size(), 3U);
  EXPECT_EQ(p.pictures[0].picture, folder / "a.png");
  EXPECT_EQ(p.pictures[1].picture, folder / "Jpg/C.png");
  ASSERT_EQ(p.notes.size(), 1U);
  EXPECT_EQ(p.notes[0],
            "2 names of the list have letters of another case than the files; the first is "
            "'A.PNG', taken for a.png");
  folder.write("A.png", "x");
  const std::string error = error_of(folder, "A.PNG 0 0 1\n");
  EXPECT_NE(error.find("line 1: found \"A.PNG\", which is "), std::string::npos) << error;
  EXPECT_EQ(read(folder, "A.png 0 0 1\n").pictures[0].picture, folder / "A.png");
}

TEST(LightPositions, FindsThePicturesOfRtiBuildersFolders) {
  const ScratchFolder folder;
  for (const char* name : {"jpeg-exports/p1.jpg", "jpeg-exports/p2.jpg"}) folder.write(name, "x");
  for (const std::string path : {"C:\\Users\\me\\project\\jpeg-exports\\", "", "../jpeg-exports/",
                                 "/home/me/project/jpeg-exports/", "D:/x/JPEG-Exports/"}) {
    const auto list = folder.write("assembly-files/project.lp",
                                   path + "p1.jpg 0 0 1\n" + path + "p2.jpg 0.6 0 0.8\n");
    const LightPositions p = read_light_positions(list);
    ASSERT_EQ(p.pictures.size(), 2U) << path;
    EXPECT_TRUE(std::filesystem::equivalent(p.pictures[1].picture, folder / "jpeg-exports/p2.jpg"));
    if (path.starts_with("..")) {
      EXPECT_TRUE(p.notes.empty());
    } else {
      EXPECT_NE(p.notes.back().find("2 pictures were not where the list says"), std::string::npos);
    }
  }
  // Any folder beside the list's own, under the name that the list says.
  folder.write("photos/tif/p3.tif", "x");
  const auto other =
      folder.write("assembly-files/o.lp", "D:\\old\\project\\photos\\tif\\p3.tif 0 0 1\n");
  EXPECT_TRUE(std::filesystem::equivalent(read_light_positions(other).pictures[0].picture,
                                          folder / "photos/tif/p3.tif"));
  // The list at the project's root, its pictures in a folder of their own.
  const auto list = folder.write("p.lp", "C:\\project\\jpeg-exports\\p1.jpg 0 0 1\n");
  EXPECT_EQ(read_light_positions(list).pictures[0].picture, folder / "jpeg-exports/p1.jpg");
}

TEST(LightPositions, TakesAnotherFoldersPicturesByTheOrderOfNames) {
  const ScratchFolder folder;
  for (const char* name : {"new/IMG_2.jpg", "new/img_10.jpg", "new/IMG_1.jpg", "new/notes.txt"}) {
    folder.write(name, "x");
  }
  const std::string first = "d1.png 0 0 1\n", second = "d2.png 0.6 0 0.8\n";
  const std::string tenth = "d10.png 0 0.6 0.8\n";
  for (const bool in_order : {true, false}) {
    const auto list =
        folder.write("dome.lp", "3\n" + first + (in_order ? second + tenth : tenth + second));
    const LightPositions p = read_light_positions(list, {.folder = folder / "new"});
    ASSERT_EQ(p.pictures.size(), 3U);
    EXPECT_EQ(p.pictures[0].picture.filename(), "IMG_1.jpg");
    const LitPicture& last = p.pictures[in_order ? 2 : 1];
    EXPECT_EQ(last.picture.filename(), "img_10.jpg");
    EXPECT_EQ(last.direction[1], 0.6);
    EXPECT_EQ(p.notes.empty(), in_order);
  }
  folder.write("new/IMG_11.TIF", "x");
  try {
    (void)read_light_positions(folder / "dome.lp", {.folder = folder / "new"});
    FAIL() << "four pictures for three lights";
  } catch (const InputError& error) {
    EXPECT_EQ(error.found(), "4 pictures (3 .jpg, 1 .tif)");
    EXPECT_EQ(error.expected(), "3, one for each light of dome.lp");
  }
}

TEST(LightPositions, LeavesOutLightsWithoutPicturesIfAskedTo) {
  const ScratchFolder folder;
  std::string list;
  for (int i = 0; i < 8; ++i) {
    std::string name(1, 'p');
    name.append(std::to_string(i)).append(".png");
    list.append(name).append(" 0.").append(std::to_string(i)).append(" 0 1\n");
    if (i != 2 && i != 5) folder.write(name, "x");
  }
  const auto lp = folder.write("c.lp", list);
  EXPECT_THROW((void)read_light_positions(lp), InputError);
  const LightPositions p = read_light_positions(lp, {.folder = {}, .skip_missing = true});
  ASSERT_EQ(p.pictures.size(), 6U);
  EXPECT_EQ(p.pictures[2].picture, folder / "p3.png");
  EXPECT_EQ(p.pictures[2].line, 4);
  EXPECT_EQ(p.notes[0],
            "2 of 8 lights are left out, as their photographs are missing: p2.png, p5.png");
  std::filesystem::remove(folder / "p0.png");
  try {
    (void)read_light_positions(lp, {.folder = {}, .skip_missing = true});
    FAIL() << "five lights do not determine six coefficients";
  } catch (const InputError& error) {
    EXPECT_EQ(error.found(), "5 of 8 (missing: p0.png, p2.png, p5.png)");
    EXPECT_EQ(error.expected(), "6 or more");
  }
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

TEST(LightPositions, ReadsARealCaptureWhoseListGoesBeyondItsCount) {
  PTM_SHARED_DATA_OR_SKIP(path, "hostile_lp/item12/dirs.lp");
  const LightPositions p = read_light_positions(path);
  EXPECT_EQ(p.pictures.size(), 47U);
  EXPECT_NE(p.notes[0].find("says 47 lights, the file has 48"), std::string::npos) << p.notes[0];
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
