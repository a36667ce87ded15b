#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "testbench/report/run_comparison.h"

namespace ptm::testbench {

/// The name of a model's picture: "rtl.png", or "rtl_03.png" if there are several frames (as many
/// digits as the last needs, at least two).
[[nodiscard]] std::string picture_name(const std::string& model, std::size_t frame,
                                       std::size_t frames);

/// report.json; every field is explained in docs/spec/report.md and held to
/// docs/spec/report.schema.json. Keys keep the order in which they are documented.
[[nodiscard]] nlohmann::ordered_json report_json(const RunResult& result,
                                                 const RunComparison& comparison);

/// Its member `unit`, which flat scenes do not have.
[[nodiscard]] nlohmann::ordered_json unit_json(const UnitSection& unit);
/// Its member `effects`, which is there only where costs of effects were asked for.
[[nodiscard]] nlohmann::ordered_json effect_costs_json(const EffectCosts& costs);

}  // namespace ptm::testbench
