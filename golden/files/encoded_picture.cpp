#include "golden/files/encoded_picture.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "golden/files/open_picture.h"

namespace ptm::golden {

bool is_picture_extension(const std::filesystem::path& path) {
  // Of a name without an extension the library takes the name itself for a format's.
  if (!path.has_extension()) return false;
  const bool known = OIIO::ImageOutput::create(path.string()) != nullptr;
  if (!known) (void)OIIO::geterror();  // or the next failure would repeat it
  return known;
}

void check_picture_name(const std::filesystem::path& path) {
  if (is_picture_extension(path)) return;
  const std::string extension = path.extension().string();
  fail_picture(path, "output",
               extension.empty() ? "a name without an extension"
                                 : "the extension " + extension + ", which no picture format has",
               "a name whose extension chooses the format, as in " +
                   std::filesystem::path(path).replace_extension(".png").filename().string() +
                   ": .png, .tif, .bmp, .tga, .jpg or another that OpenImageIO writes");
}

EncodedPicture::EncodedPicture(std::filesystem::path path, const OIIO::ImageSpec& spec)
    : path_(std::move(path)) {
  check_picture_name(path_);
  output_ = OIIO::ImageOutput::create(path_.string());
  // Its writer asks for five halvings, and of a smaller picture leaves a file without pixels.
  constexpr int least_jpeg2000 = 32;
  if (output_->format_name() == std::string_view("jpeg2000") &&
      std::min(spec.width, spec.height) < least_jpeg2000) {
    fail_picture(path_, "output",
                 std::to_string(spec.width) + " x " + std::to_string(spec.height) + " in JPEG 2000",
                 "at least 32 pixels a side, or another format");
  }
  std::string name = path_.string();
  if (output_->supports("ioproxy")) {
    output_->set_ioproxy(&memory_);
  } else {
    descriptor_ = memfd_create("ptmsim-picture", MFD_CLOEXEC);
    if (descriptor_ < 0) {
      fail_picture(path_, "output", std::strerror(errno), "a file in memory");
    }
    name = "/proc/self/fd/" + std::to_string(descriptor_);
  }
  if (!output_->open(name, spec)) fail();
}

EncodedPicture::~EncodedPicture() {
  output_.reset();
  if (descriptor_ >= 0) close(descriptor_);
}

void EncodedPicture::rows(int first, int end, const std::uint8_t* samples) {
  if (!output_->write_scanlines(first, end, 0, OIIO::TypeDesc::UINT8, samples)) fail();
}

std::vector<std::uint8_t> EncodedPicture::finish() {
  if (!output_->close()) fail();
  output_.reset();
  if (descriptor_ < 0) return memory_.buffer();
  std::vector<std::uint8_t> bytes;
  std::array<std::uint8_t, 65536> chunk{};
  for (off_t at = 0;;) {
    const ssize_t count = pread(descriptor_, chunk.data(), chunk.size(), at);
    if (count <= 0) break;
    bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + count);
    at += count;
  }
  // These codecs do not check their writes. A file as long as the process's size limit allows was
  // cut there.
  rlimit limit{};
  if (getrlimit(RLIMIT_FSIZE, &limit) == 0 && bytes.size() >= limit.rlim_cur) {
    fail_picture(path_, "output", std::strerror(EFBIG), "a picture that can be written");
  }
  if (bytes.empty()) fail_picture(path_, "output", "no bytes", "a picture that can be written");
  return bytes;
}

void EncodedPicture::fail() const {
  fail_picture(path_, "output", output_->geterror(), "a picture that can be written");
}

}  // namespace ptm::golden
