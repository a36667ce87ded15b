#include "golden/scene/scene.h"

#include <gtest/gtest.h>

#include <fstream>

namespace ptm::golden {
namespace {

class SceneFile : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path write(const std::string& text) const {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    const auto path = std::filesystem::path(testing::TempDir()) /
                      (std::string(info->name()) + std::to_string(getpid()) + ".toml");
    std::ofstream(path) << text;
    return path;
  }

  /// What the reader says is wrong with a scene.
  [[nodiscard]] std::string complaint(const std::string& text) const {
    const auto path = write(text);
    try {
      (void)read_scene(path);
    } catch (const InputError& error) {
      EXPECT_EQ(error.file(), path.string());
      return error.place() + "|" + error.found() + "|" + error.expected();
    }
    return "nothing";
  }
};

const std::string kMap = "[map]\nfile = \"a.ptm\"\n";
const std::string kLight = "[[light]]\ndirection = [-1, 0.5]\n";

TEST_F(SceneFile, HoldsEverythingItSays) {
  const auto path =
      write("models = [\"rtl\", \"golden\"]\n" + kMap + "[image]\nsize = [64, 32]\n" + kLight +
            "[[light]]\ndirection = [0, 0]\n[hardware]\npreset = \"wide\"\ntmus = 2\n");
  const Scene scene = read_scene(path);
  EXPECT_EQ(scene.map, path.parent_path() / "a.ptm");
  EXPECT_EQ(scene.size, (std::array<int, 2>{64, 32}));
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.lights[0].u, -1);
  EXPECT_EQ(scene.lights[0].v, 0.5);
  EXPECT_EQ(scene.lights[1].place, "line 9 (light[1].direction)");
  ASSERT_EQ(scene.hardware.list.size(), 2U);
  EXPECT_EQ(scene.hardware.list[0].name, "preset");
  EXPECT_EQ(scene.hardware.list[0].text, "wide");
  EXPECT_EQ(scene.hardware.list[1].text, "2");
  EXPECT_EQ(scene.hardware.list[1].place, "line 12");
  EXPECT_EQ(scene.models, (std::vector<std::string>{"rtl", "golden"}));
}

TEST_F(SceneFile, NamesAllFourModelsByDefault) {
  EXPECT_EQ(read_scene(write(kMap + kLight)).models.size(), 4U);
}

TEST_F(SceneFile, RefusesUnknownKeysAtEveryLevelWithTheirLine) {
  EXPECT_EQ(complaint("colour = 1\n" + kMap + kLight),
            "line 1|unknown key 'colour'|one of map, image, light, hardware, models");
  EXPECT_EQ(complaint(kMap + "scale = 2\n" + kLight), "line 3|unknown key 'map.scale'|one of file");
  EXPECT_EQ(complaint(kMap + kLight + "power = 2\n"),
            "line 5|unknown key 'light[0].power'|one of direction");
}

TEST_F(SceneFile, RefusesWrongTypesWithWhatWasExpected) {
  EXPECT_EQ(complaint("map = 3\n" + kLight), "line 1 (map)|an integer|a table");
  EXPECT_EQ(complaint("[map]\nfile = 3\n" + kLight), "line 2 (map.file)|an integer|a string");
  EXPECT_EQ(complaint(kMap + "[[light]]\ndirection = \"up\"\n"),
            "line 4 (light[0].direction)|a string|an array");
  EXPECT_EQ(complaint(kMap + "[[light]]\ndirection = [0, true]\n"),
            "line 4 (light[0].direction[1])|a boolean|a finite number");
  EXPECT_EQ(complaint("hardware = 3\n" + kMap + kLight), "line 1 (hardware)|an integer|a table");
}

TEST_F(SceneFile, RefusesValuesOutOfRange) {
  EXPECT_EQ(complaint(kMap + "[[light]]\ndirection = [nan, 0]\n"),
            "line 4 (light[0].direction[0])|nan|a finite number");
  EXPECT_EQ(complaint(kMap + "[[light]]\ndirection = [0, 0, 1]\n"),
            "line 4 (light[0].direction)|3 elements|2 elements");
  EXPECT_EQ(complaint(kMap + kLight + "[image]\nsize = [0, 4]\n"),
            "line 6 (image.size[0])|0|an integer from 1 to 16384");
  EXPECT_EQ(complaint("models = [\"gold\"]\n" + kMap + kLight),
            "line 1 (models)|'gold'|golden, reference, pipeline or rtl");
  EXPECT_EQ(complaint("models = []\n" + kMap + kLight),
            "line 1 (models)|an empty list|at least one model");
}

TEST_F(SceneFile, RefusesWhatIsMissing) {
  EXPECT_EQ(complaint(kLight), "line 1|no [map]|[map] with file = \"...\"");
  EXPECT_EQ(complaint(kMap),
            "the file|no [[light]]|at least one [[light]] with direction = [lu, lv]");
  EXPECT_THROW((void)read_scene("nowhere.toml"), InputError);
}

TEST_F(SceneFile, RefusesWhatIsNotToml) { EXPECT_EQ(complaint("[map\n").substr(0, 6), "line 1"); }

}  // namespace
}  // namespace ptm::golden
