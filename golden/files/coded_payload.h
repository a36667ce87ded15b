#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "golden/files/ptm_header.h"

namespace ptm::golden {

/// Sees that a coded file's listed sizes end where the file ends, and that its texels are within
/// the limits of plane_codec.h. Throws InputError.
void check_coded_size(const PtmHeader& header, const std::string& file);

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

/// The inverse. JPEG-LS holds every byte, or each within `near`; planes build on what a reader will
/// have, so the loss of one does not add to another's. Differences of lossy planes are
/// clamped, not wrapped. Bytes come as side information where JPEG changed them and `exact` is set,
/// where JPEG-LS is farther off than `near` (a clamped difference), and always where a reader that
/// does not wrap would go astray: a sum outside 0..255, or, in JPEG, a coded byte of 0 in a
/// predicted plane.
[[nodiscard]] CodedPayload format_coded_payload(const PtmMap& map, const PtmWriteOptions& options);

}  // namespace ptm::golden
