#include "testbench/report/level_picture.h"

#include <gtest/gtest.h>

namespace ptm::testbench {
namespace {

golden::ImageReal picture(int width, int height, std::vector<double> samples) {
  golden::ImageReal image(width, height, 1);
  image.samples = std::move(samples);
  return image;
}

TEST(LevelPicture, RoundsToTheNearestLevelWithTiesUpwardAndLimits) {
  const golden::Image8 levels = level_picture(picture(6, 1, {0.49, 0.5, 254.5, 255, 300, -4}));
  const std::vector<std::uint8_t> expected = {0, 1, 255, 255, 255, 0};
  EXPECT_EQ(levels.samples, expected);
}

TEST(LevelPicture, AveragesBlocksAndWhatIsLeftOfThemAtTheEdges) {
  const golden::Image8 small = level_picture(picture(3, 3,
                                                     {10, 20, 7,  //
                                                      30, 41, 9,  //
                                                      50, 60, 200}),
                                             2);
  ASSERT_EQ(small.width, 2);
  ASSERT_EQ(small.height, 2);
  const std::vector<std::uint8_t> expected = {25, 8, 55, 200};  // 101/4 = 25.25
  EXPECT_EQ(small.samples, expected);
}

TEST(LevelPicture, IsReducedByTheLeastWholeFactorThatFits) {
  EXPECT_EQ(reduction_to(256, 100, 256), 1);
  EXPECT_EQ(reduction_to(100, 257, 256), 2);
  EXPECT_EQ(reduction_to(1, 1, 256), 1);
}

}  // namespace
}  // namespace ptm::testbench
