#include <turbojpeg.h>

#include <memory>
#include <stdexcept>

#include "golden/files/plane_codec.h"

namespace ptm::golden {
namespace {

struct HandleDeleter {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using Handle = std::unique_ptr<void, HandleDeleter>;

struct BufferDeleter {
  void operator()(unsigned char* buffer) const { tjFree(buffer); }
};

Handle made(tjhandle handle) {
  if (handle == nullptr) throw std::runtime_error("libjpeg-turbo cannot start");
  return Handle(handle);
}

[[noreturn]] void fail(const PlaneStream& stream, tjhandle handle) {
  throw InputError(stream.file, stream.place, std::string("broken JPEG: ") + tjGetErrorStr2(handle),
                   "a whole grey 8-bit JPEG stream");
}

}  // namespace

Plane decode_jpeg_plane(const PlaneStream& stream, int width, int height) {
  const Handle handle = made(tjInitDecompress());
  int found_width = 0, found_height = 0, subsampling = 0, colorspace = 0;
  if (tjDecompressHeader3(handle.get(), stream.bytes.data(), stream.bytes.size(), &found_width,
                          &found_height, &subsampling, &colorspace) != 0) {
    fail(stream, handle.get());
  }
  if (colorspace != TJCS_GRAY) {
    throw InputError(stream.file, stream.place, "a JPEG stream in colour", "one grey component");
  }
  const auto blocks_across = (static_cast<std::uint64_t>(width) + 7) / 8;
  const auto blocks_down = (static_cast<std::uint64_t>(height) + 7) / 8;
  check_plane_size(stream, found_width, found_height, width, height, blocks_across * blocks_down);
  Plane plane(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  // A warning means texels that the stream does not hold; a hundred scans cost time, not texels.
  const int flags = TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS;
  if (tjDecompress2(handle.get(), stream.bytes.data(), stream.bytes.size(), plane.bytes().data(),
                    width, width, height, TJPF_GRAY, flags) != 0) {
    fail(stream, handle.get());
  }
  return plane;
}

std::vector<std::uint8_t> encode_jpeg_plane(std::span<const std::uint8_t> plane, int width,
                                            int height, int quality) {
  const Handle handle = made(tjInitCompress());
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  const int failed = tjCompress2(handle.get(), plane.data(), width, width, height, TJPF_GRAY,
                                 &buffer, &size, TJSAMP_GRAY, quality, TJFLAG_ACCURATEDCT);
  const std::unique_ptr<unsigned char, BufferDeleter> owner(buffer);
  if (failed != 0) {
    throw std::runtime_error(std::string("libjpeg-turbo: ") + tjGetErrorStr2(handle.get()));
  }
  return {buffer, buffer + size};
}

}  // namespace ptm::golden
