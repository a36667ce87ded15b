#include "golden/files/encoded_picture.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "golden/files/open_picture.h"

namespace ptm::golden {

EncodedPicture::EncodedPicture(std::filesystem::path path, const OIIO::ImageSpec& spec)
    : path_(std::move(path)), output_(OIIO::ImageOutput::create(path_.string())) {
  if (!output_) fail_picture(path_, "output", OIIO::geterror(), "an extension of a picture format");
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
