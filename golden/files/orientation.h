#pragma once
#include <array>

namespace ptm::golden {

/// How a stored picture is to be turned or mirrored to stand upright: tag Orientation of Exif and
/// TIFF. 1 as it is, 2 mirrored left to right, 3 half a turn, 4 mirrored top to bottom, 5 mirrored
/// along the diagonal from the top left, 6 a quarter turn clockwise, 7 mirrored along the other
/// diagonal, 8 a quarter turn counterclockwise.
class Orientation {
 public:
  Orientation() = default;
  /// Of a picture stored with this size. A tag outside 1..8 means nothing and counts as 1.
  Orientation(int tag, int width, int height);

  [[nodiscard]] int tag() const { return tag_; }
  /// Rows of the upright picture are columns of the stored one.
  [[nodiscard]] bool swaps() const { return tag_ >= 5; }
  /// Rows of the upright picture come in the order in which they are stored.
  [[nodiscard]] bool keeps_rows() const { return tag_ <= 2; }
  [[nodiscard]] int width() const { return swaps() ? height_ : width_; }   ///< upright
  [[nodiscard]] int height() const { return swaps() ? width_ : height_; }  ///< upright

  /// Where a stored pixel (x, y) stands in the upright picture.
  [[nodiscard]] std::array<int, 2> upright(int x, int y) const;
  /// Where a pixel of the upright picture is stored.
  [[nodiscard]] std::array<int, 2> stored(int x, int y) const;

 private:
  int tag_ = 1, width_ = 0, height_ = 0;  ///< stored
};

}  // namespace ptm::golden
