#include "golden/fit/capture.h"

#include "tests/fit/scratch_folder.h"

namespace ptm::golden {
namespace {

using tests::ScratchFolder;

std::string error_of(const std::filesystem::path& lp) {
  try {
    (void)read_capture(lp);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ReadCapture, KeepsOrderAndLevelsOfThePhotographs) {
  const ScratchFolder folder;
  folder.picture("a.png", 4, 3, 10);
  folder.picture("b.png", 4, 3, 200);
  const Capture capture = read_capture(folder.write("c.lp", "b.png 0 0 1\na.png 0.6 0 0.8\n"));
  EXPECT_EQ(capture.width, 4);
  EXPECT_EQ(capture.height, 3);
  EXPECT_EQ(capture.names, (std::vector<std::string>{"b.png", "a.png"}));
  EXPECT_EQ(capture.photographs[0].samples, std::vector<float>(36, 200));
  EXPECT_EQ(capture.photographs[1].samples, std::vector<float>(36, 10));
  EXPECT_EQ(capture.directions[1][0], 0.6);
}

TEST(ReadCapture, TurnsGreyPhotographsIntoThreeEqualChannels) {
  const ScratchFolder folder;
  Image8 grey(2, 1, 1);
  grey.samples = {7, 9};
  write_picture(folder / "g.png", grey);
  const Capture capture = read_capture(folder.write("c.lp", "g.png 0 0 1\n"));
  EXPECT_EQ(capture.photographs[0].samples, (std::vector<float>{7, 7, 7, 9, 9, 9}));
}

TEST(ReadCapture, NamesTheLineOfAPhotographOfAnotherSize) {
  const ScratchFolder folder;
  folder.picture("a.png", 4, 3);
  folder.picture("b.png", 3, 4);
  const std::string error = error_of(folder.write("c.lp", "2\na.png 0 0 1\nb.png 0.6 0 0.8\n"));
  EXPECT_NE(error.find("line 3: found b.png of 3 x 4 pixels, expected 4 x 3"), std::string::npos)
      << error;
}

TEST(ReadCapture, NamesThePhotographThatIsNoPicture) {
  const ScratchFolder folder;
  folder.picture("a.png");
  folder.write("b.png", "this is no picture");
  EXPECT_NE(error_of(folder.write("c.lp", "a.png 0 0 1\nb.png 0.6 0 0.8\n")).find("b.png"),
            std::string::npos);
}

}  // namespace
}  // namespace ptm::golden
