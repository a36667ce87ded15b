#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "golden/files/ptm_header.h"

namespace ptm::golden {

/// Bytes a texel takes in a raw payload: lrgb 9, rgb 18, lum 8.
[[nodiscard]] constexpr std::size_t raw_bytes_per_texel(MapKind kind) {
  return kind == MapKind::lrgb ? 9 : kind == MapKind::rgb ? 18 : 8;
}

/// Sees that a raw payload ends where the file ends. Throws InputError.
void check_raw_size(const PtmHeader& header, const std::string& file);

/// Fills the map of `header` from a raw payload. `bytes` is the whole file. The payload must end
/// where the file ends; nothing is allocated before that is known. Throws InputError.
[[nodiscard]] PtmMap read_raw_payload(const PtmHeader& header, std::span<const std::uint8_t> bytes,
                                      const std::string& file);

/// The inverse: the payload's bytes. `interleaved` is the layout of PTM_1.1, lrgb only.
[[nodiscard]] std::vector<std::uint8_t> format_raw_payload(const PtmMap& map, bool interleaved);

}  // namespace ptm::golden
