#pragma once
#include <cstddef>
#include <vector>

#include "golden/files/ptm_map.h"
#include "golden/scene/scene.h"
#include "testbench/run/run_result.h"

namespace ptm::testbench {

/// Golden's side of the worst-pixel table: the real number behind each of the hardware's values,
/// under the same name. d0..d5 are the coefficients in levels, p and t the polynomial's terms, acc
/// and lum the luminance, which golden does not clamp.
[[nodiscard]] std::vector<NamedValue> golden_values(const golden::PtmMap& map, std::size_t texel,
                                                    const golden::Light& light);

}  // namespace ptm::testbench
