#pragma once
#include <vector>

#include "golden/files/ptm_map.h"
#include "model/quantize/maps.h"
#include "model/reference/eval_config.h"

namespace ptm::testbench {

/// For each texel, how far at most the hardware's lit channels lie from golden's unrounded ones,
/// in levels, under any light of the unit disc: error_bound() of its polynomials, an LRGB texel's
/// times its brightest channel.
///
/// Holds for a map that is stored verbatim; else what storing changed comes on top. Infinite where
/// the luminance may go beyond what D6 holds, for which golden has no limit.
[[nodiscard]] std::vector<double> texel_error_bounds(const golden::PtmMap& map,
                                                     const quantize::StoredMap& stored,
                                                     const reference::EvalConfig& config);

}  // namespace ptm::testbench
