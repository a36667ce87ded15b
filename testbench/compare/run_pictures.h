#pragma once
#include <vector>

#include "testbench/compare/run_difference.h"
#include "testbench/compare/run_files.h"

namespace ptm::testbench {

/// What differs between the pictures of models that both runs have: one difference a model, of all
/// its lights; and one for each picture that is missing or of another size. Where one of the runs
/// is a report without its pictures, digests are compared. Throws golden::InputError for a picture
/// that cannot be read.
[[nodiscard]] std::vector<RunDifference> compare_run_pictures(const RunFiles& a, const RunFiles& b);

}  // namespace ptm::testbench
