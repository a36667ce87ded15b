#include "golden/fit/capture.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "golden/files/light_positions.h"
#include "golden/files/picture_file.h"

namespace ptm::golden {
namespace {

constexpr double kBrightest = 1e9;  ///< levels; beyond it a picture holds no photograph

/// Three channels, half the memory of the reader's doubles; levels up to 65,536 steps stay exact.
/// Light is never negative: float pictures that say so are raised to 0 and counted.
Image<float> as_rgb(const ImageReal& picture, const std::string& file, std::size_t& negative) {
  Image<float> rgb(picture.width, picture.height, 3);
  const auto channels = static_cast<std::size_t>(picture.channels);
  for (std::size_t p = 0; p * 3 < rgb.samples.size(); ++p) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double level = picture.samples[p * channels + (channels == 3 ? c : 0)];
      if (!(std::abs(level) <= kBrightest)) {
        const auto width = static_cast<std::size_t>(picture.width);
        throw InputError(file,
                         "pixel " + std::to_string(p % width) + ", " + std::to_string(p / width),
                         "sample " + std::to_string(level), "a level that light can have");
      }
      negative += level < 0 ? 1U : 0U;
      rgb.samples[p * 3 + c] = static_cast<float>(std::max(level, 0.0));
    }
  }
  return rgb;
}

std::string size_of(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

}  // namespace

Capture read_capture(const std::filesystem::path& lp) {
  const LightPositions positions = read_light_positions(lp);
  Capture capture;
  capture.notes = positions.notes;
  capture.photographs.resize(positions.pictures.size());
  std::vector<std::size_t> negative(positions.pictures.size());
  tbb::parallel_for(std::size_t{0}, positions.pictures.size(), [&](std::size_t i) {
    const std::filesystem::path& picture = positions.pictures[i].picture;
    capture.photographs[i] = as_rgb(read_picture(picture), picture.string(), negative[i]);
  });
  const std::size_t below = std::accumulate(negative.begin(), negative.end(), std::size_t{0});
  if (below > 0) {
    capture.notes.push_back(std::to_string(below) + " negative samples taken as black");
  }
  capture.width = capture.photographs.front().width;
  capture.height = capture.photographs.front().height;
  for (std::size_t i = 0; i < positions.pictures.size(); ++i) {
    const LitPicture& lit = positions.pictures[i];
    const Image<float>& photograph = capture.photographs[i];
    if (photograph.width != capture.width || photograph.height != capture.height) {
      throw InputError(lp.string(), "line " + std::to_string(lit.line),
                       lit.picture.filename().string() + " of " +
                           size_of(photograph.width, photograph.height) + " pixels",
                       size_of(capture.width, capture.height) + " like the first photograph");
    }
    capture.names.push_back(lit.picture.filename().string());
    capture.directions.push_back(lit.direction);
  }
  return capture;
}

}  // namespace ptm::golden
