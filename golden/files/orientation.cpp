#include "golden/files/orientation.h"

namespace ptm::golden {

Orientation::Orientation(int tag, int width, int height)
    : tag_(tag >= 1 && tag <= 8 ? tag : 1), width_(width), height_(height) {}

std::array<int, 2> Orientation::upright(int x, int y) const {
  const int left = width_ - 1 - x, up = height_ - 1 - y;  // counted from the other end
  switch (tag_) {
    case 2:
      return {left, y};
    case 3:
      return {left, up};
    case 4:
      return {x, up};
    case 5:
      return {y, x};
    case 6:
      return {up, x};
    case 7:
      return {up, left};
    case 8:
      return {y, left};
    default:
      return {x, y};
  }
}

std::array<int, 2> Orientation::stored(int x, int y) const {
  // All are their own inverse but the two quarter turns, which are each other's.
  if (tag_ == 6) return {y, height_ - 1 - x};
  if (tag_ == 8) return {width_ - 1 - y, x};
  if (tag_ == 7) return {width_ - 1 - y, height_ - 1 - x};
  return upright(x, y);
}

}  // namespace ptm::golden
