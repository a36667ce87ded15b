#include "golden/files/open_picture.h"

#include <algorithm>
#include <cstdint>

#include "golden/files/whole_file.h"

namespace ptm::golden {
namespace {

/// The most pixels read from one picture, 16384 x 16384.
constexpr std::int64_t most_pixels = std::int64_t{1} << 28;

/// Deflate gives at most 1032 bytes a byte and baseline JPEG 1024; runs that claim more are lies.
/// Small pictures of exotic codecs may pass: their memory does not matter.
constexpr std::uint64_t largest_ratio = 1100;
constexpr std::uint64_t unsuspicious_bytes = std::uint64_t{1} << 28;

void check_spec(const std::filesystem::path& path, const OIIO::ImageSpec& spec) {
  const std::string size = std::to_string(spec.width) + " x " + std::to_string(spec.height) +
                           " x " + std::to_string(spec.nchannels);
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 ||
      spec.nchannels > 4) {
    fail_picture(path, "size", size, "a flat picture of 1 to 4 channels");
  }
  if (std::int64_t{spec.width} * spec.height > most_pixels) {
    fail_picture(path, "size", size, "at most " + std::to_string(most_pixels) + " pixels");
  }
  std::error_code error;
  const std::uintmax_t file_bytes = std::filesystem::file_size(path, error);
  const std::uint64_t bytes = spec.image_bytes(true);
  if (!error && bytes > unsuspicious_bytes && bytes / largest_ratio > file_bytes) {
    fail_picture(path, "size", size + " in " + std::to_string(file_bytes) + " bytes",
                 "a file that can hold so many samples");
  }
}

}  // namespace

void fail_picture(const std::filesystem::path& path, const std::string& place, std::string found,
                  const std::string& expected) {
  if (found.empty()) found = "an error without a message";
  std::replace(found.begin(), found.end(), '\n', ' ');
  throw InputError(path.string(), place, found, expected);
}

std::unique_ptr<OIIO::ImageInput> open_picture(const std::filesystem::path& path) {
  require_plain_file(path, kAPicture);
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1;  // colours as stored: alpha is dropped, not multiplied in
  auto input = OIIO::ImageInput::open(path.string(), &config);
  if (!input) fail_picture(path, "file", OIIO::geterror(), kAPicture);
  check_spec(path, input->spec());
  return input;
}

}  // namespace ptm::golden
