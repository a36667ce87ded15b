#include "testbench/report/level_picture.h"

#include <algorithm>

#include "testbench/compare/picture_difference.h"

namespace ptm::testbench {
namespace {

double block_mean(const golden::ImageReal& image, int column, int row, int c, int block) {
  const int right = std::min(image.width, (column + 1) * block);
  const int below = std::min(image.height, (row + 1) * block);
  double sum = 0;
  for (int y = row * block; y < below; ++y) {
    for (int x = column * block; x < right; ++x) sum += image.at(x, y, c);
  }
  return sum / ((right - column * block) * (below - row * block));
}

}  // namespace

golden::Image8 level_picture(const golden::ImageReal& image, int block) {
  golden::Image8 picture((image.width + block - 1) / block, (image.height + block - 1) / block,
                         image.channels);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      for (int c = 0; c < picture.channels; ++c) {
        const double level = block == 1 ? image.at(x, y, c) : block_mean(image, x, y, c, block);
        picture.at(x, y, c) = static_cast<std::uint8_t>(level8(level));
      }
    }
  }
  return picture;
}

int reduction_to(int width, int height, int side) {
  return std::max(1, (std::max(width, height) + side - 1) / side);
}

}  // namespace ptm::testbench
