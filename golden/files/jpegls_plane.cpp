#include <charls/charls.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "golden/files/figure_text.h"
#include "golden/files/plane_codec.h"

namespace ptm::golden {
namespace {

/// Room for any stream: a texel takes 32 bits at most (ISO 14495-1, LIMIT), and each of those bytes
/// may bring a stuffed bit. Untouched memory costs nothing.
std::size_t largest_stream(std::size_t texels) { return 5 * texels + 4096; }

void check_frame(const PlaneStream& stream, const charls::frame_info& frame, int width,
                 int height) {
  if (frame.component_count != 1 || frame.bits_per_sample != 8) {
    throw InputError(stream.file, stream.place,
                     count_of(frame.component_count, "component") + " of " +
                         count_of(frame.bits_per_sample, "bit"),
                     "1 component of 8 bits");
  }
  constexpr std::uint64_t longest_run = 32768;
  const std::uint64_t runs = (static_cast<std::uint64_t>(width) + longest_run - 1) / longest_run;
  check_plane_size(stream, frame.width, frame.height, width, height,
                   runs * static_cast<std::uint64_t>(height));
}

/// The stream up to its last end marker, FFD9. Coded texels cannot hold these bytes (an FF is
/// followed by a byte below 80). CharLS 2.4.1, given a stream without one, works on for minutes.
std::span<const std::uint8_t> up_to_end_marker(const PlaneStream& stream) {
  constexpr std::array<std::uint8_t, 2> marker{0xff, 0xd9};
  const auto found =
      std::find_end(stream.bytes.begin(), stream.bytes.end(), marker.begin(), marker.end());
  if (found == stream.bytes.end()) {
    throw InputError(stream.file, stream.place, "broken JPEG-LS: no end marker",
                     "a whole grey 8-bit JPEG-LS stream");
  }
  return {stream.bytes.begin(), found + marker.size()};
}

}  // namespace

Plane decode_jpegls_plane(const PlaneStream& stream, int width, int height) {
  try {
    const auto bytes = up_to_end_marker(stream);
    charls::jpegls_decoder decoder(bytes.data(), bytes.size(), true);
    check_frame(stream, decoder.frame_info(), width, height);
    Plane plane(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    decoder.decode(plane.bytes().data(), plane.bytes().size());
    return plane;
  } catch (const charls::jpegls_error& error) {
    throw InputError(stream.file, stream.place, std::string("broken JPEG-LS: ") + error.what(),
                     "a whole grey 8-bit JPEG-LS stream");
  }
}

std::vector<std::uint8_t> encode_jpegls_plane(std::span<const std::uint8_t> plane, int width,
                                              int height, int near) {
  Plane buffer(largest_stream(plane.size()));
  charls::jpegls_encoder encoder;
  encoder.frame_info({static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 8, 1});
  encoder.near_lossless(near);
  encoder.destination(buffer.bytes().data(), buffer.bytes().size());
  const std::size_t size = encoder.encode(plane.data(), plane.size());
  const auto stream = buffer.bytes().first(size);
  return {stream.begin(), stream.end()};
}

}  // namespace ptm::golden
