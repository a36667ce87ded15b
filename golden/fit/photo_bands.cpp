#include "golden/fit/photo_bands.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>

namespace ptm::golden {

PhotoBands::PhotoBands(std::span<Capture* const> captures, std::size_t budget, std::size_t beside) {
  for (Capture* capture : captures) {
    for (PictureRows& photograph : capture->photographs) {
      sources_.push_back({&photograph, capture->region});
    }
  }
  if (sources_.empty()) throw std::invalid_argument("bands of no photograph");
  const Region& region = sources_.front().region;
  const bool same = std::all_of(sources_.begin(), sources_.end(), [&](const Source& source) {
    return source.region.width == region.width && source.region.height == region.height;
  });
  if (!same) throw std::invalid_argument("bands of captures of different sizes");
  width_ = static_cast<std::size_t>(region.width);
  height_ = region.height;
  const std::size_t row_bytes = width_ * (sources_.size() * 3 * sizeof(float) + beside);
  const std::size_t rows = std::clamp<std::size_t>(budget / row_bytes, 1, std::size_t(height_));
  // Equal bands rather than a last one of a few rows.
  const int bands = (height_ + static_cast<int>(rows) - 1) / static_cast<int>(rows);
  rows_ = (height_ + bands - 1) / bands;
}

bool PhotoBands::all_decode_once() const {
  return std::all_of(sources_.begin(), sources_.end(),
                     [](const Source& source) { return source.rows->decodes_once(); });
}

void PhotoBands::read(int index, Band& band) {
  band.first_row = index * rows_;
  band.rows = std::min(rows_, height_ - band.first_row);
  if (index < 0 || band.rows <= 0) throw std::invalid_argument("no such band");
  band.texels = width_ * static_cast<std::size_t>(band.rows);
  band.samples.resize(sources_.size() * 3 * band.texels);
  std::vector<SampleCounts> counts(sources_.size());
  std::mutex one_at_a_time;
  tbb::parallel_for(std::size_t{0}, sources_.size(), [&](std::size_t i) {
    const Source& source = sources_[i];
    std::unique_lock lock(one_at_a_time, std::defer_lock);
    if (bands() > 1 && !source.rows->streams()) lock.lock();
    float* samples = band.samples.data() + i * 3 * band.texels;
    const auto plane = [&](std::size_t c) {
      return std::span(samples + c * band.texels, band.texels);
    };
    const Region part{source.region.x, source.region.y + band.first_row, source.region.width,
                      band.rows};
    source.rows->read(part, {plane(0), plane(1), plane(2)}, counts[i]);
  });
  for (const SampleCounts& one : counts) {
    counts_.saturated += one.saturated;
    counts_.negative += one.negative;
  }
}

void for_each_tile(std::size_t texels,
                   const std::function<void(std::size_t, std::size_t, std::size_t)>& work) {
  tbb::parallel_for(std::size_t{0}, tiles_of(texels), [&](std::size_t tile) {
    const std::size_t first = tile * kTileTexels;
    work(tile, first, std::min(kTileTexels, texels - first));
  });
}

}  // namespace ptm::golden
