#include "golden/files/picture_file.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "golden/files/whole_file.h"

namespace ptm::golden {
namespace {

constexpr const char* a_picture = "a picture that OpenImageIO reads";

/// The most pixels read from one picture, 16384 x 16384.
constexpr std::int64_t most_pixels = std::int64_t{1} << 28;

/// Deflate gives at most 1032 bytes a byte and baseline JPEG 1024; runs that claim more are lies.
/// Small pictures of exotic codecs may pass: their memory does not matter.
constexpr std::uint64_t largest_ratio = 1100;
constexpr std::uint64_t unsuspicious_bytes = std::uint64_t{1} << 28;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& place,
                       std::string found, const std::string& expected) {
  if (found.empty()) found = "an error without a message";
  std::replace(found.begin(), found.end(), '\n', ' ');
  throw InputError(path.string(), place, found, expected);
}

void check_spec(const std::filesystem::path& path, const OIIO::ImageSpec& spec) {
  const std::string size = std::to_string(spec.width) + " x " + std::to_string(spec.height) +
                           " x " + std::to_string(spec.nchannels);
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 ||
      spec.nchannels > 4) {
    fail(path, "size", size, "a flat picture of 1 to 4 channels");
  }
  if (std::int64_t{spec.width} * spec.height > most_pixels) {
    fail(path, "size", size, "at most " + std::to_string(most_pixels) + " pixels");
  }
  std::error_code error;
  const std::uintmax_t file_bytes = std::filesystem::file_size(path, error);
  const std::uint64_t bytes = spec.image_bytes(true);
  if (!error && bytes > unsuspicious_bytes && bytes / largest_ratio > file_bytes) {
    fail(path, "size", size + " in " + std::to_string(file_bytes) + " bytes",
         "a file that can hold so many samples");
  }
}

/// Reads all channels as Stored and hands them on as levels.
template <class Stored>
std::vector<double> read_levels(const std::filesystem::path& path, OIIO::ImageInput& input,
                                OIIO::TypeDesc type, double unit) {
  const OIIO::ImageSpec& spec = input.spec();
  std::vector<Stored> stored(static_cast<std::size_t>(spec.width) *
                             static_cast<std::size_t>(spec.height) *
                             static_cast<std::size_t>(spec.nchannels));
  if (!input.read_image(0, 0, 0, spec.nchannels, type, stored.data())) {
    fail(path, "pixels", input.geterror(), a_picture);
  }
  // A codec may warn, fill the rest with grey, and call that a success.
  if (input.has_error()) fail(path, "pixels", input.geterror(), a_picture);
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

}  // namespace

ImageReal read_picture(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    fail(path, "file", "No such file or directory", a_picture);
  }
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1;  // colours as stored: alpha is dropped, not multiplied in
  const auto input = OIIO::ImageInput::open(path.string(), &config);
  if (!input) fail(path, "file", OIIO::geterror(), a_picture);
  const OIIO::ImageSpec spec = input->spec();
  check_spec(path, spec);
  const std::vector<double> levels = read_all_channels(path, *input);
  if (!std::all_of(levels.begin(), levels.end(), [](double v) { return std::isfinite(v); })) {
    fail(path, "pixels", "infinite samples or NaN", "finite samples");
  }
  ImageReal image(spec.width, spec.height, spec.nchannels < 3 ? 1 : 3);
  const auto channels = static_cast<std::size_t>(image.channels);
  const auto stored = static_cast<std::size_t>(spec.nchannels);
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    image.samples[i] = levels[i / channels * stored + i % channels];
  }
  return image;
}

void write_picture(const std::filesystem::path& path, const Image8& image) {
  if (image.width < 1 || image.height < 1 || (image.channels != 1 && image.channels != 3)) {
    throw std::invalid_argument("write_picture: an image of 1 or 3 channels is needed");
  }
  PendingFile pending(path);
  const std::string name = pending.path().string();
  const auto output = OIIO::ImageOutput::create(name);
  if (!output) fail(path, "output", OIIO::geterror(), "an extension of a picture format");
  // No date and no history: the same samples give the same bytes.
  const OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::UINT8);
  const bool written = output->open(name, spec) &&
                       output->write_image(OIIO::TypeDesc::UINT8, image.samples.data()) &&
                       output->close();
  if (!written) fail(path, "output", output->geterror(), "a picture that can be written");
  pending.commit();
}

}  // namespace ptm::golden
