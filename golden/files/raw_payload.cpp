#include "golden/files/raw_payload.h"

#include <algorithm>
#include <string>

#include "golden/files/figure_text.h"

namespace ptm::golden {
namespace {

/// A run of bytes of every texel: where it lies in the payload and where in the map.
///
///     payload[block + texel * payload_stride + i] = (*map)[map_first + texel * map_stride + i]
///
/// for i < count; the payload's texels run bottom row first.
struct Run {
  std::size_t block = 0;
  std::size_t payload_stride = 0;
  bool color = false;
  std::size_t map_first = 0;
  std::size_t map_stride = 0;
  std::size_t count = 0;
};

std::vector<Run> runs_of(const PtmMap& map, bool interleaved) {
  const std::size_t texels = map.texels();
  switch (map.kind) {
    case MapKind::lrgb:
      if (interleaved) return {{0, 9, false, 0, 6, 6}, {6, 9, true, 0, 3, 3}};
      return {{0, 6, false, 0, 6, 6}, {6 * texels, 3, true, 0, 3, 3}};
    case MapKind::rgb:
      return {{0, 6, false, 0, 18, 6},
              {6 * texels, 6, false, 6, 18, 6},
              {12 * texels, 6, false, 12, 18, 6}};
    case MapKind::lum:
      return {{0, 8, false, 0, 6, 6}, {6, 8, true, 0, 2, 2}};
  }
  return {};
}

/// Calls copy(payload index, map index, run) for every texel of every run.
template <class Copy>
void for_each_run(const PtmMap& map, bool interleaved, Copy copy) {
  const auto width = static_cast<std::size_t>(map.width);
  const auto height = static_cast<std::size_t>(map.height);
  for (const Run& run : runs_of(map, interleaved)) {
    for (std::size_t row = 0; row < height; ++row) {
      for (std::size_t x = 0; x < width; ++x) {
        const std::size_t in_file = (height - 1 - row) * width + x;
        const std::size_t in_map = row * width + x;
        copy(run.block + in_file * run.payload_stride, run.map_first + in_map * run.map_stride,
             run);
      }
    }
  }
}

}  // namespace

void check_raw_size(const PtmHeader& header, const std::string& file) {
  const std::uint64_t found = header.info.file_bytes - header.info.header_bytes;
  const std::size_t per_texel = raw_bytes_per_texel(header.map.kind);
  const std::size_t texels = header.map.texels();
  const std::string layout = std::to_string(header.map.width) + " x " +
                             std::to_string(header.map.height) + " x " + std::to_string(per_texel) +
                             " bytes";
  // The first comparison keeps the product within 64 bits.
  if (texels > found || texels * per_texel > found) {
    throw InputError(
        file, "byte " + std::to_string(header.info.header_bytes + found) + " (payload)",
        "the end of the file after " + count_of(found, "byte") + " of payload", layout);
  }
  const std::size_t expected = texels * per_texel;
  if (expected < found) {
    throw InputError(
        file, "byte " + std::to_string(header.info.header_bytes + expected) + " (payload)",
        count_of(found - expected, "more byte"),
        "the end of the file after " + std::to_string(expected) + " bytes (" + layout + ")");
  }
}

PtmMap read_raw_payload(const PtmHeader& header, std::span<const std::uint8_t> bytes,
                        const std::string& file) {
  const auto payload = bytes.subspan(header.info.header_bytes);
  check_raw_size(header, file);
  PtmMap map = header.map;
  map.coef.resize(map.texels() * 6 * map.polynomials());
  map.color.resize(map.texels() * map.color_bytes());
  for_each_run(map, header.info.version == "PTM_1.1",
               [&](std::size_t from, std::size_t to, const Run& run) {
                 auto& target = run.color ? map.color : map.coef;
                 std::copy_n(payload.data() + from, run.count, target.data() + to);
               });
  return map;
}

std::vector<std::uint8_t> format_raw_payload(const PtmMap& map, bool interleaved) {
  std::vector<std::uint8_t> payload(map.texels() * raw_bytes_per_texel(map.kind));
  for_each_run(map, interleaved, [&](std::size_t to, std::size_t from, const Run& run) {
    const auto& source = run.color ? map.color : map.coef;
    std::copy_n(source.data() + from, run.count, payload.data() + to);
  });
  return payload;
}

}  // namespace ptm::golden
