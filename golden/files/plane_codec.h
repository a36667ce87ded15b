#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "golden/files/plane.h"
#include "golden/files/ptm_file.h"

/// One plane as a stream of its own: grey JPEG or JPEG-LS, 8 bit.
namespace ptm::golden {

/// The largest plane taken from a coded file, 16384 x 16384. A flat JPEG-LS stream may honestly
/// hold half a million texels a byte, so its length alone bounds nothing.
constexpr std::size_t largest_coded_plane = std::size_t{1} << 28;

/// A coded file whose planes together take more bytes than this must have a byte for so many of
/// them. No photographed map comes near that ratio; a file of kilobytes may claim gigabytes.
constexpr std::uint64_t unsuspicious_planes = std::uint64_t{1} << 28;
constexpr std::uint64_t most_planes_per_byte = 1100;

/// A stream inside a file, for decoding and for messages.
struct PlaneStream {
  std::span<const std::uint8_t> bytes;
  const std::string& file;
  std::string place;  ///< "plane 3 at byte 1234"
};

/// Decodes a stream of exactly width x height texels, one component, 8 bit. Whatever the codec
/// reports, warnings included, throws InputError. Memory is taken only when the stream's own header
/// agrees with width and height, and the stream is long enough to hold them:
///
///     JPEG     each block of 8 x 8 takes 1 bit or more (a Huffman code of its DC term)
///     JPEG-LS  each started run of 32768 texels in a row takes 1 bit or more
[[nodiscard]] Plane decode_jpeg_plane(const PlaneStream& stream, int width, int height);
[[nodiscard]] Plane decode_jpegls_plane(const PlaneStream& stream, int width, int height);

/// Encodes a plane: baseline JFIF with the accurate DCT, or JPEG-LS whose bytes come back within
/// `near` (0: unchanged; at most 127).
/// Throws std::runtime_error where the codec cannot (a JPEG side above 65500).
[[nodiscard]] std::vector<std::uint8_t> encode_jpeg_plane(std::span<const std::uint8_t> plane,
                                                          int width, int height, int quality);
[[nodiscard]] std::vector<std::uint8_t> encode_jpegls_plane(std::span<const std::uint8_t> plane,
                                                            int width, int height, int near = 0);

/// Both decoders' check of a stream's header against the file's, before any memory is taken.
/// `least_bits` is what a stream of that size takes at least.
void check_plane_size(const PlaneStream& stream, std::int64_t found_width,
                      std::int64_t found_height, int width, int height, std::uint64_t least_bits);

}  // namespace ptm::golden
