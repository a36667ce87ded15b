#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ptm::golden {

/// A picture in memory: samples [height][width][channels], row 0 at the top.
template <class Sample>
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<Sample> samples;

  Image() = default;
  Image(int w, int h, int c)
      : width(w),
        height(h),
        channels(c),
        samples(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) *
                static_cast<std::size_t>(c)) {}

  [[nodiscard]] std::size_t index(int x, int y, int c = 0) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(channels) +
           static_cast<std::size_t>(c);
  }
  [[nodiscard]] Sample& at(int x, int y, int c = 0) { return samples[index(x, y, c)]; }
  [[nodiscard]] const Sample& at(int x, int y, int c = 0) const { return samples[index(x, y, c)]; }
};

using Image8 = Image<std::uint8_t>;
using ImageReal = Image<double>;  ///< real-valued, in units of 8-bit levels (0..255)

}  // namespace ptm::golden
