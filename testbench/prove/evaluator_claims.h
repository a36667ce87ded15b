#pragma once
#include <memory>
#include <vector>

#include "model/reference/eval_config.h"
#include "testbench/prove/claim.h"

/// What is claimed of the evaluator: steps D1 to D7 of docs/spec/datapath.md, each RTL module
/// against its C++ function.
namespace ptm::testbench {

/// One claim a step. The inputs of a step are all values that its predecessors' outputs can have,
/// as the reference's own ranges say, so the claims of all steps make one of the whole.
[[nodiscard]] std::vector<std::unique_ptr<Claim>> step_claims(const reference::EvalConfig& config);

}  // namespace ptm::testbench
