#include "golden/files/picture_file.h"
#include "golden/render/light_map.h"
#include "tests/program/small_map.h"
#include "tests/run_program.h"
#include "tests/shared_data.h"

namespace ptm {
namespace {

class RenderCommand : public tests::Program {
 protected:
  golden::ImageReal rendered(const std::filesystem::path& map, const std::string& options) {
    const tests::Outcome outcome = run("render " + tests::quoted(map) + " " + options + " --out " +
                                       tests::quoted(file("picture.png")));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return golden::read_picture(file("picture.png"));
  }
};

TEST_F(RenderCommand, EqualsRtiViewersPictureOfATabletInEverySample) {
  PTM_SHARED_DATA_OR_SKIP(folder, "tablet2");
  const auto ours =
      rendered(folder / "tablet2_LRGB.ptm", "--light -1,0 --model golden --rounding truncate");
  const auto theirs = golden::read_picture(folder / "tablet2_LRGB_RTIViewer.png");
  ASSERT_EQ(ours.samples.size(), 786432U);
  EXPECT_EQ(ours.samples, theirs.samples);
}

TEST_F(RenderCommand, IsTheSameByEveryHardwareModelAndPreset) {
  golden::write_ptm(file("map.ptm"), tests::small_map(golden::MapKind::rgb, 13, 11));
  for (const std::string preset : {"paper8", "base", "wide"}) {
    const std::string options = "--light 0.25,-0.5 --preset " + preset + " --model ";
    const auto reference = rendered(file("map.ptm"), options + "reference");
    EXPECT_EQ(rendered(file("map.ptm"), options + "pipeline").samples, reference.samples);
    EXPECT_EQ(rendered(file("map.ptm"), options + "rtl").samples, reference.samples);
  }
}

TEST_F(RenderCommand, RepeatsTexelsWhenThePictureIsLargerThanTheMap) {
  golden::write_ptm(file("map.ptm"), tests::small_map(golden::MapKind::lrgb, 3, 2));
  const auto small = rendered(file("map.ptm"), "--light 0,0");
  for (const std::string model : {"golden", "rtl"}) {
    const auto exact = rendered(file("map.ptm"), "--light 0,0 --model " + model);
    const auto large = rendered(file("map.ptm"), "--light 0,0 --size 9x4 --model " + model);
    ASSERT_EQ(large.width, 9);
    ASSERT_EQ(large.height, 4);
    EXPECT_EQ(large.at(8, 3, 1), exact.at(2, 1, 1));
    EXPECT_EQ(large.at(2, 1, 2), exact.at(0, 0, 2));
  }
}

TEST_F(RenderCommand, RefusesWhatItCannotDraw) {
  const auto map = file("map.ptm");
  golden::write_ptm(map, tests::small_map(golden::MapKind::lrgb, 3, 2));
  const std::string out = " --out " + tests::quoted(file("picture.png"));
  const std::string command = "render " + tests::quoted(map);
  expect_refused(command + " --light 1.5,0 --model rtl --preset paper8" + out, "lu = 1.5");
  expect_refused(command + " --light nan,0" + out, "--light");
  expect_refused("render absent.ptm --light 0,0" + out, "absent.ptm");
  EXPECT_EQ(run(command + " --light 1" + out).code, 2);
  EXPECT_EQ(run(command + " --light 0,0 --model gpu" + out).code, 2);
}

TEST_F(RenderCommand, LeavesTheOldPictureWhenTheMapIsBroken) {
  write("picture.png", "the old one");
  const auto map = write("map.ptm", "PTM_1.2\nPTM_FORMAT_LRGB\n4\n");
  expect_refused(
      "render " + tests::quoted(map) + " --light 0,0 --out " + tests::quoted(file("picture.png")),
      "map.ptm");
  EXPECT_EQ(tests::text_of(file("picture.png")), "the old one");
}

}  // namespace
}  // namespace ptm
