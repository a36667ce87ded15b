#pragma once
#include <optional>

#include "contract/unit_config.h"
#include "model/reference/eval_config.h"

/// UnitConfig, what a texture unit is built with, is generated from contract/parameters.toml.
namespace ptm::reference {

/// Sets of one tag bank.
[[nodiscard]] constexpr int cache_sets(const UnitConfig& unit) {
  return unit.cache_kib * 4 / unit.ways;
}

/// Throws std::invalid_argument naming the first field outside its range, its value and the range.
void validate(const UnitConfig& config);

/// What keeps a unit of these parameters from being built: the first one outside its range, those
/// of the evaluator first; nothing if it can be built.
[[nodiscard]] std::optional<ParameterFault> unit_fault(const EvalConfig& config,
                                                       const UnitConfig& unit);

}  // namespace ptm::reference
