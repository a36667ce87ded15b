#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "golden/files/input_error.h"

namespace ptm::golden {

/// A rectangle of pixels; row 0 is the top.
struct Region {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Oddities counted while rows were read.
struct SampleCounts {
  std::uint64_t saturated = 0;  ///< samples at white or above
  std::uint64_t negative = 0;   ///< samples below black, taken as black
};

/// A photograph that is read some rows at a time, each decoded once if they are asked for in order.
///
/// It is turned and mirrored as its tag Orientation (Exif, TIFF) says, unless it is asked for as it
/// is stored: rows, sizes and regions are the upright picture's.
///
/// Levels are 0..255 as in read_picture(). With `linear`, integer samples are sRGB and are decoded:
/// 255 * EOTF(s / white) with EOTF of IEC 61966-2-1; float samples are linear already.
class PictureRows {
 public:
  /// Reads the header only. Throws InputError.
  PictureRows(const std::filesystem::path& path, bool linear, bool as_stored = false);
  PictureRows(PictureRows&&) noexcept;
  PictureRows& operator=(PictureRows&&) noexcept;
  ~PictureRows();

  [[nodiscard]] int width() const;
  [[nodiscard]] int height() const;
  /// True if rows in order need no more memory than a few rows; false where the format or its
  /// decoder holds the whole picture (progressive JPEG, interlaced PNG, tiles, other formats).
  [[nodiscard]] bool streams() const;
  /// True if in addition rows in order are decoded once: they are stored in this order. Of turned
  /// pictures each read() decodes what it needs anew, some rows at a time.
  [[nodiscard]] bool decodes_once() const;
  [[nodiscard]] int orientation() const;  ///< the tag that is applied, 1..8; 1 does nothing

  /// Reads a rectangle into three planes [height][width]; a grey picture fills all three.
  /// Throws InputError: pixels that cannot be decoded, samples that are not finite.
  void read(const Region& region, const std::array<std::span<float>, 3>& planes,
            SampleCounts& counts);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ptm::golden
