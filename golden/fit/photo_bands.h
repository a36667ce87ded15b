#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "golden/fit/capture.h"

namespace ptm::golden {

/// The same texels of all photographs, in levels: plane(light, channel)[texel].
struct PhotoTile {
  std::size_t texels = 0;
  std::size_t stride = 0;          ///< samples from one plane to the next
  const float* samples = nullptr;  ///< [light][channel][stride]
  [[nodiscard]] const float* plane(std::size_t light, std::size_t channel) const {
    return samples + (light * 3 + channel) * stride;
  }
};

/// Some rows of all photographs.
struct Band {
  int first_row = 0;  ///< within the region
  int rows = 0;
  std::size_t texels = 0;
  std::vector<float> samples;  ///< [photograph][channel][texel]

  /// Texels of the region above the band.
  [[nodiscard]] std::size_t before(int width) const {
    return static_cast<std::size_t>(first_row) * static_cast<std::size_t>(width);
  }
  [[nodiscard]] PhotoTile tile(std::size_t first, std::size_t count, std::size_t photograph) const {
    return {count, texels, samples.data() + photograph * 3 * texels + first};
  }
};

/// Reads the photographs of captures of one size band by band, all of them at once on all cores.
///
/// A band has as many rows as `budget` bytes allow, at least one, where each texel takes its
/// samples and `beside` bytes of the caller's. Memory is that, a few rows for each open decoder,
/// and one whole picture where a format cannot be read by rows (PictureRows::streams()); such
/// pictures are then decoded one at a time and once a band.
class PhotoBands {
 public:
  /// The captures must stay where they are, and their regions have the same size.
  PhotoBands(std::span<Capture* const> captures, std::size_t budget, std::size_t beside = 0);

  [[nodiscard]] int bands() const { return (height_ + rows_ - 1) / rows_; }
  /// Whether no photograph is decoded more than once (PictureRows::decodes_once()).
  [[nodiscard]] bool all_decode_once() const;
  /// Reuses the memory of `band`. Throws InputError. Calls in order decode each photograph once.
  void read(int index, Band& band);
  /// Of everything read so far.
  [[nodiscard]] const SampleCounts& counts() const { return counts_; }

 private:
  struct Source {
    PictureRows* rows;
    Region region;
  };
  std::vector<Source> sources_;
  int height_ = 0, rows_ = 1;
  std::size_t width_ = 0;
  SampleCounts counts_;
};

inline constexpr std::size_t kTileTexels = 4096;

/// Calls work(tile, first texel, texels) for tiles of kTileTexels, the last one smaller, on all
/// cores. Tiles do not depend on the number of cores, so sums made tile by tile do not either.
void for_each_tile(std::size_t texels,
                   const std::function<void(std::size_t, std::size_t, std::size_t)>& work);
[[nodiscard]] constexpr std::size_t tiles_of(std::size_t texels) {
  return (texels + kTileTexels - 1) / kTileTexels;
}

}  // namespace ptm::golden
