#include "golden/files/open_picture.h"

#include <algorithm>
#include <cstdint>

#include "golden/files/file_kind.h"

namespace ptm::golden {
namespace {

/// The most pixels read from one picture, 16384 x 16384.
constexpr std::int64_t most_pixels = std::int64_t{1} << 28;

/// Deflate gives at most 1032 bytes a byte and baseline JPEG 1024; runs that claim more are lies.
/// Small pictures of exotic codecs may pass: their memory does not matter.
constexpr std::uint64_t largest_ratio = 1100;
constexpr std::uint64_t unsuspicious_bytes = std::uint64_t{1} << 28;

void check_size(const std::filesystem::path& path, std::int64_t width, std::int64_t height,
                std::uint64_t bytes_a_pixel) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  // Sides first: their product might not be a number any more.
  if (width > most_pixels || height > most_pixels || width * height > most_pixels) {
    fail_picture(path, "size", size, "at most " + std::to_string(most_pixels) + " pixels");
  }
  std::error_code error;
  const std::uintmax_t file_bytes = std::filesystem::file_size(path, error);
  const std::uint64_t bytes = static_cast<std::uint64_t>(width * height) * bytes_a_pixel;
  if (!error && bytes > unsuspicious_bytes && bytes / largest_ratio > file_bytes) {
    fail_picture(path, "size",
                 size + " x " + std::to_string(bytes_a_pixel) + " bytes in " +
                     std::to_string(file_bytes) + " bytes",
                 "a file that can hold so many samples");
  }
}

/// The kind of picture by its first bytes; whatever is none, no library is asked to look at.
FileKind picture_kind(const std::filesystem::path& path) {
  FileKind kind = read_file_kind(path, kAPicture);
  if (kind.type != FileType::picture) {
    fail_picture(path, "file", kind.name, "a picture: " + picture_formats());
  }
  if (kind.size) {
    constexpr std::uint64_t rgba = 4;  // what those decoders take
    check_size(path, std::max<std::int64_t>(kind.size->first, 0),
               std::max<std::int64_t>(kind.size->second, 0), rgba);
  }
  return kind;
}

void check_spec(const std::filesystem::path& path, const OIIO::ImageSpec& spec) {
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 ||
      spec.nchannels > 4) {
    fail_picture(path, "size",
                 std::to_string(spec.width) + " x " + std::to_string(spec.height) + " x " +
                     std::to_string(spec.nchannels),
                 "a flat picture of 1 to 4 channels");
  }
  check_size(path, spec.width, spec.height, spec.pixel_bytes(true));
}

}  // namespace

void fail_picture(const std::filesystem::path& path, const std::string& place, std::string found,
                  const std::string& expected) {
  if (found.empty()) found = "an error without a message";
  std::replace(found.begin(), found.end(), '\n', ' ');
  throw InputError(path.string(), place, found, expected);
}

std::unique_ptr<OIIO::ImageInput> open_picture(const std::filesystem::path& path) {
  const FileKind kind = picture_kind(path);
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1;  // colours as stored: alpha is dropped, not multiplied in
  if (kind.format.empty()) {
    auto input = OIIO::ImageInput::open(path.string(), &config);
    if (!input) fail_picture(path, "file", OIIO::geterror(), kAPicture);
    check_spec(path, input->spec());
    return input;
  }
  // The format's own reader, whatever the extension: asked by name, the library tries them all.
  auto input = OIIO::ImageInput::create(kind.format);
  if (!input) fail_picture(path, "file", kind.name + ", " + OIIO::geterror(), kAPicture);
  OIIO::ImageSpec spec;
  if (!input->open(path.string(), spec, config)) {
    fail_picture(path, "file", input->geterror(), kAPicture);
  }
  check_spec(path, input->spec());
  return input;
}

}  // namespace ptm::golden
