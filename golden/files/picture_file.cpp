#include "golden/files/picture_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "golden/files/encoded_picture.h"
#include "golden/files/open_picture.h"
#include "golden/files/orientation.h"
#include "golden/files/pending_file.h"

namespace ptm::golden {
namespace {

/// Reads all channels as Stored and hands them on as levels.
template <class Stored>
std::vector<double> read_levels(const std::filesystem::path& path, OIIO::ImageInput& input,
                                OIIO::TypeDesc type, double unit) {
  const OIIO::ImageSpec& spec = input.spec();
  std::vector<Stored> stored(static_cast<std::size_t>(spec.width) *
                             static_cast<std::size_t>(spec.height) *
                             static_cast<std::size_t>(spec.nchannels));
  if (!input.read_image(0, 0, 0, spec.nchannels, type, stored.data())) {
    fail_picture(path, "pixels", input.geterror(), kAPicture);
  }
  // A codec may warn, fill the rest with grey, and call that a success.
  if (input.has_error()) fail_picture(path, "pixels", input.geterror(), kAPicture);
  std::vector<double> levels(stored.size());
  std::transform(stored.begin(), stored.end(), levels.begin(),
                 [unit](Stored sample) { return static_cast<double>(sample) * 255 / unit; });
  return levels;
}

std::vector<double> read_all_channels(const std::filesystem::path& path, OIIO::ImageInput& input) {
  switch (input.spec().format.basetype) {
    case OIIO::TypeDesc::UINT8:
      return read_levels<std::uint8_t>(path, input, OIIO::TypeDesc::UINT8, 255);
    case OIIO::TypeDesc::UINT16:
      return read_levels<std::uint16_t>(path, input, OIIO::TypeDesc::UINT16, 65535);
    default:
      return read_levels<double>(path, input, OIIO::TypeDesc::DOUBLE, 1);
  }
}

ImageReal upright(ImageReal image, int tag) {
  const Orientation orientation(tag, image.width, image.height);
  if (orientation.tag() == 1) return image;
  ImageReal turned(orientation.width(), orientation.height(), image.channels);
  for (int y = 0; y < turned.height; ++y) {
    for (int x = 0; x < turned.width; ++x) {
      const auto from = orientation.stored(x, y);
      for (int c = 0; c < image.channels; ++c) turned.at(x, y, c) = image.at(from[0], from[1], c);
    }
  }
  return turned;
}

/// All channels as the file has them, upright: [height][width][channels], finite.
ImageReal read_channels(const std::filesystem::path& path) {
  const auto input = open_picture(path);
  const OIIO::ImageSpec spec = input->spec();
  ImageReal image;
  image.width = spec.width;
  image.height = spec.height;
  image.channels = spec.nchannels;
  image.samples = read_all_channels(path, *input);
  if (!std::all_of(image.samples.begin(), image.samples.end(),
                   [](double v) { return std::isfinite(v); })) {
    fail_picture(path, "pixels", "infinite samples or NaN", "finite samples");
  }
  return upright(std::move(image), spec.get_int_attribute("Orientation", 1));
}

}  // namespace

ImageReal read_picture(const std::filesystem::path& path) {
  const ImageReal stored = read_channels(path);
  ImageReal image(stored.width, stored.height, stored.channels < 3 ? 1 : 3);
  const auto channels = static_cast<std::size_t>(image.channels);
  const auto all = static_cast<std::size_t>(stored.channels);
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    image.samples[i] = stored.samples[i / channels * all + i % channels];
  }
  return image;
}

ImageReal read_picture_with_alpha(const std::filesystem::path& path) {
  const ImageReal stored = read_channels(path);
  ImageReal image(stored.width, stored.height, 4);
  const bool grey = stored.channels < 3, alpha = stored.channels % 2 == 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = stored.at(x, y, grey ? 0 : c);
      image.at(x, y, 3) = alpha ? stored.at(x, y, stored.channels - 1) : 255;
    }
  }
  return image;
}

std::vector<std::uint8_t> encode_picture(const std::filesystem::path& path, const Image8& image) {
  if (image.width < 1 || image.height < 1 || (image.channels != 1 && image.channels != 3)) {
    throw std::invalid_argument("a picture to write: an image of 1 or 3 channels is needed");
  }
  // No date and no history: the same samples give the same bytes.
  EncodedPicture encoded(
      path, OIIO::ImageSpec(image.width, image.height, image.channels, OIIO::TypeDesc::UINT8));
  encoded.rows(0, image.height, image.samples.data());
  return encoded.finish();
}

void write_picture(const std::filesystem::path& path, const Image8& image) {
  PendingFile pending(path);
  pending.write(encode_picture(path, image));
  pending.commit();
}

}  // namespace ptm::golden
