#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "testbench/report/run_comparison.h"

namespace ptm::testbench {

/// The name of a model's picture: "rtl.png", or "rtl_03.png" if there are several frames (as many
/// digits as the last needs, at least two).
[[nodiscard]] std::string picture_name(const std::string& model, std::size_t frame,
                                       std::size_t frames);

/// `version` of the reports that this program writes and compares; docs/spec/report.md, "Versions".
inline constexpr int kReportVersion = 2;

/// Size and 8-bit samples of a picture as 32 digits: equal for equal pictures, and different in
/// practice for others (testbench/rtl/digest.h).
[[nodiscard]] std::string picture_digest(const golden::ImageReal& image);

/// report.json; every field is explained in docs/spec/report.md and held to
/// docs/spec/report.schema.json. Keys keep the order in which they are documented.
[[nodiscard]] nlohmann::ordered_json report_json(const RunResult& result,
                                                 const RunComparison& comparison);

/// Its member `unit`, which flat scenes do not have.
[[nodiscard]] nlohmann::ordered_json unit_json(const UnitSection& unit);
/// Its member `effects`, which is there only where costs of effects were asked for.
[[nodiscard]] nlohmann::ordered_json effect_costs_json(const EffectCosts& costs);
/// The times of that member's runs, by model.
[[nodiscard]] nlohmann::ordered_json effect_times_json(const EffectCosts& costs);

}  // namespace ptm::testbench
