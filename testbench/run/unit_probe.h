#pragma once
#include <memory>
#include <vector>

#include "testbench/run/run_result.h"
#include "testbench/run/unit_models.h"

namespace ptm::testbench {

/// Answers for any pixel of a scene: its fragment, the filtered fields, every step of the
/// evaluator, what was combined, and the cycle in which it left. Golden's row holds the sample that
/// the fragment was made from. The RTL's inner values are not tapped: its row holds what left it.
/// A pixel that no object covers has no values.
[[nodiscard]] PixelProbe make_unit_probe(std::shared_ptr<const UnitJob> job,
                                         std::vector<UnitTimed> timed);

}  // namespace ptm::testbench
