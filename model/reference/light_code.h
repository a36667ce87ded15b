#pragma once
#include <optional>

#include "model/reference/eval_config.h"
#include "model/reference/integer.h"

namespace ptm::reference {

/// The code of a light coordinate, the only way a real light enters the datapath.
///
///     code = floor(l * 2^light_frac + 1/2), limited to +-(2^(light_int-1+light_frac) - 1)
///
/// |l| = 2^(light_int-1) is limited silently, so (-1, 0) is legal on paper8; beyond it, or if l is
/// not finite, there is no code.
[[nodiscard]] std::optional<Value> light_code(const EvalConfig& config, double l);

/// The largest |l| that has a code: 2^(light_int - 1).
[[nodiscard]] double light_limit(const EvalConfig& config);

}  // namespace ptm::reference
