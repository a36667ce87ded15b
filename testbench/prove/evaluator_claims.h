#pragma once
#include <memory>
#include <vector>

#include "model/reference/eval_config.h"
#include "testbench/prove/claim.h"

/// What is claimed of docs/spec/datapath.md: steps D1 to D7 and the lerp, each RTL module against
/// its C++ function.
namespace ptm::testbench {

/// One claim a step. The inputs of a step are all values that its predecessors' outputs can have,
/// as the reference's own ranges say, so the claims of all steps make one of the whole.
[[nodiscard]] std::vector<std::unique_ptr<Claim>> step_claims(const reference::EvalConfig& config);

/// Eq. 14's lerp of stored values of so many bits, for every a, b and f; the result needs no more
/// bits than they have.
[[nodiscard]] std::unique_ptr<Claim> lerp_claim(reference::Rounding rounding, int bits);

}  // namespace ptm::testbench
