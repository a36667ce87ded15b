#pragma once
#include <string>
#include <vector>

#include "golden/files/ptm_map.h"
#include "model/quantize/import.h"
#include "model/quantize/quantize.h"

/// Where maps cross between files (golden) and hardware (model).
namespace ptm::testbench {

/// A file's map as the hardware of this configuration holds it.
struct StoredTexture {
  quantize::StoredMap map;
  std::string why_not_verbatim;  ///< empty if the file's integers were taken as they stand
};

/// Verbatim where that is possible, otherwise quantised anew from the real coefficients
/// (coef_k - bias_k) * scale_k, weighed for lights all round the hemisphere.
/// Colour stays in the file's map: 8-bit either way. A lum map's chroma is not added here.
[[nodiscard]] StoredTexture store_texture(const golden::PtmMap& map,
                                          const reference::EvalConfig& config,
                                          quantize::Method method);

/// A stored map as a file's map, scale 2^-shift, so that store_texture() takes it verbatim.
/// Requires coefficients of at most 8 bits (std::invalid_argument); the colour as PtmMap wants it.
[[nodiscard]] golden::PtmMap to_ptm(const quantize::StoredMap& stored, golden::MapKind kind,
                                    std::vector<std::uint8_t> color);

}  // namespace ptm::testbench
