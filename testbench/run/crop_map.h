#pragma once
#include <string>

#include "golden/files/picture_rows.h"
#include "golden/files/ptm_map.h"

namespace ptm::testbench {

/// The part of a map under a rectangle of its picture's pixels: (x, y) is the top left one, as in
/// PtmMap, although files list rows from the bottom. Scales, biases and the colour matrix are the
/// map's, so the part is lit as it is within the whole. Throws InputError about `file` if the map
/// has no such part.
[[nodiscard]] golden::PtmMap crop_map(const golden::PtmMap& map, const golden::Region& part,
                                      const std::string& file);

}  // namespace ptm::testbench
