#include "golden/files/plane_codec.h"

#include "golden/files/figure_text.h"

namespace ptm::golden {

void check_plane_size(const PlaneStream& stream, std::int64_t found_width,
                      std::int64_t found_height, int width, int height, std::uint64_t least_bits) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  if (found_width != width || found_height != height) {
    throw InputError(
        stream.file, stream.place,
        "a stream of " + std::to_string(found_width) + " x " + std::to_string(found_height),
        size + " as the header says");
  }
  if (least_bits > stream.bytes.size() * 8) {
    throw InputError(stream.file, stream.place,
                     count_of(stream.bytes.size(), "byte") + " for " + size + " texels",
                     "at least " + count_of((least_bits + 7) / 8, "byte"));
  }
}

}  // namespace ptm::golden
