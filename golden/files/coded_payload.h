#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "golden/files/ptm_header.h"

namespace ptm::golden {

/// Fills the map of `header` from planes coded as JPEG or JPEG-LS. `bytes` is the whole file. The
/// sizes that the header lists must end where the file ends. Throws InputError. Odd but harmless
/// things are added to header.info.notes.
[[nodiscard]] PtmMap read_coded_payload(PtmHeader& header, std::span<const std::uint8_t> bytes,
                                        const std::string& file);

/// A payload and the header lines that describe it.
struct CodedPayload {
  PtmFileInfo info;  ///< quality, transforms, order, references and sizes
  std::vector<std::uint8_t> bytes;
};

/// The inverse. JPEG-LS holds every byte. JPEG differences are clamped, not wrapped, and bytes come
/// as side information where exact and the codec changed them; and always where a reader that does
/// not wrap would go astray: a sum outside 0..255, or a coded byte of 0 in a predicted plane.
[[nodiscard]] CodedPayload format_coded_payload(const PtmMap& map, const PtmWriteOptions& options);

}  // namespace ptm::golden
