#pragma once
#include <string>
#include <vector>

#include "testbench/compare/run_difference.h"
#include "testbench/compare/run_files.h"
#include "testbench/compare/tolerance.h"

namespace ptm::testbench {

/// All that differs between two runs, and what of it is allowed.
struct RunVerdict {
  std::vector<RunDifference> differences;  ///< those not allowed first, each part by weight
  bool by_digests = false;                 ///< pictures were compared by their digests
  [[nodiscard]] std::size_t allowed() const;
  [[nodiscard]] std::size_t refused() const { return differences.size() - allowed(); }
};

/// Compares reports and pictures. What differs in the same way in several places is one difference.
/// Weight: the order of DifferenceKind; within a kind the larger part of a, or the larger error.
/// Throws golden::InputError as require_versions() and compare_run_pictures() do.
[[nodiscard]] RunVerdict compare_runs(const RunFiles& a, const RunFiles& b,
                                      const Tolerance& tolerance);

}  // namespace ptm::testbench
