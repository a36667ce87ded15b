#include "golden/files/picture_header.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "golden/files/file_kind.h"
#include "golden/files/open_picture.h"

namespace ptm::golden {
namespace {

/// Rows [first, end) of all channels as stored; a tiled picture only as a whole.
template <class Stored>
void read_rows(const std::filesystem::path& path, OIIO::ImageInput& input, int first, int end,
               OIIO::TypeDesc type, std::vector<Stored>& samples) {
  const OIIO::ImageSpec& spec = input.spec();
  samples.resize(static_cast<std::size_t>(end - first) * static_cast<std::size_t>(spec.width) *
                 static_cast<std::size_t>(spec.nchannels));
  const bool whole = first == 0 && end == spec.height;
  const bool done = whole ? input.read_image(0, 0, 0, spec.nchannels, type, samples.data())
                          : input.read_scanlines(0, 0, spec.y + first, spec.y + end, 0, 0,
                                                 spec.nchannels, type, samples.data());
  // A codec may warn, fill the rest with grey, and call that a success.
  if (!done || input.has_error()) fail_picture(path, "pixels", input.geterror(), kAPicture);
}

/// `unit` is a stored sample of white.
template <class Stored>
std::vector<LevelRange> ranges_of(const std::filesystem::path& path, OIIO::ImageInput& input,
                                  OIIO::TypeDesc type, double unit) {
  const OIIO::ImageSpec spec = input.spec();
  const auto channels = static_cast<std::size_t>(spec.nchannels);
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<LevelRange> ranges(channels < 3 ? 1 : 3, LevelRange{none, -none, 0});
  constexpr int rows = 64;
  const int step = spec.tile_width != 0 ? spec.height : rows;
  std::vector<Stored> samples;
  for (int first = 0; first < spec.height; first += step) {
    read_rows(path, input, first, std::min(spec.height, first + step), type, samples);
    for (std::size_t i = 0; i < samples.size(); i += channels) {
      for (std::size_t c = 0; c < ranges.size(); ++c) {
        const double level = static_cast<double>(samples[i + c]) * 255 / unit;
        if (!std::isfinite(level)) {
          fail_picture(path, "pixels", "infinite samples or NaN", "finite samples");
        }
        ranges[c].least = std::min(ranges[c].least, level);
        ranges[c].greatest = std::max(ranges[c].greatest, level);
        ranges[c].mean += level;
      }
    }
  }
  for (LevelRange& range : ranges) {
    range.mean /= static_cast<double>(spec.width) * static_cast<double>(spec.height);
  }
  return ranges;
}

}  // namespace

PictureHeader read_picture_header(const std::filesystem::path& path) {
  const auto input = open_picture(path);
  const OIIO::ImageSpec& spec = input->spec();
  return {spec.width, spec.height, spec.nchannels, read_file_kind(path, kAPicture).name,
          spec.format.c_str()};
}

std::vector<LevelRange> read_level_ranges(const std::filesystem::path& path) {
  const auto input = open_picture(path);
  switch (input->spec().format.basetype) {
    case OIIO::TypeDesc::UINT8:
      return ranges_of<std::uint8_t>(path, *input, OIIO::TypeDesc::UINT8, 255);
    case OIIO::TypeDesc::UINT16:
      return ranges_of<std::uint16_t>(path, *input, OIIO::TypeDesc::UINT16, 65535);
    default:
      return ranges_of<double>(path, *input, OIIO::TypeDesc::DOUBLE, 1);
  }
}

}  // namespace ptm::golden
