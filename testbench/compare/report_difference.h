#pragma once
#include <nlohmann/json.hpp>
#include <vector>

#include "testbench/compare/run_difference.h"

namespace ptm::testbench {

/// What differs between two reports of one version, but for `made_by`, `timing` and what names
/// pictures. What is in one of them only is one difference, whatever it holds; what repeats another
/// field (docs/spec/compare.md, "What is compared") is left out. In no order.
[[nodiscard]] std::vector<RunDifference> compare_reports(const nlohmann::ordered_json& a,
                                                         const nlohmann::ordered_json& b);

}  // namespace ptm::testbench
