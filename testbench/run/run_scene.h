#pragma once
#include <optional>
#include <string>
#include <vector>

#include "golden/scene/scene.h"
#include "testbench/run/flat_job.h"
#include "testbench/run/run_result.h"

namespace ptm::testbench {

/// What a run found.
struct SceneRun {
  RunResult result;
  reference::UnitConfig unit;  ///< of a unit scene: with what its effects have built in
  /// Pixels that pipeline and RTL let go in different cycles; nothing if one of them did not run.
  std::optional<std::uint64_t> late_pixels;
  std::vector<std::string> faults;  ///< what ended a timed model early, "model: what"
};

/// Draws the scene with each model it names. Pipeline and RTL run in processes of their own while
/// golden and reference run in this one. Throws golden::InputError.
[[nodiscard]] SceneRun run_scene(const golden::Scene& scene);

}  // namespace ptm::testbench
