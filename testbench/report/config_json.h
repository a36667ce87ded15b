#pragma once
#include <nlohmann/json.hpp>

#include "testbench/run/run_config.h"

namespace ptm::testbench {

/// A report's member `config`: every parameter by its name, in tables `evaluator`, `unit`, and of a
/// unit scene `effects` (if the unit has parts for any), `memory`, `stress` and `frames`. Names are
/// those of docs/spec/datapath.md, unit-timing.md, effects.md and scene.md.
[[nodiscard]] nlohmann::ordered_json config_json(const RunConfig& config);

}  // namespace ptm::testbench
