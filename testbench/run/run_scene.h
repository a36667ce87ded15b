#pragma once
#include "golden/scene/scene.h"
#include "testbench/run/flat_job.h"
#include "testbench/run/run_result.h"

namespace ptm::testbench {

/// What a run found: the pictures, and whether the models that must be equal are.
struct SceneRun {
  RunResult result;
  std::vector<std::string> disagreements;  ///< empty, or a sentence each: exit code 1
};

/// Draws the scene with each model it names. Pipeline and RTL run in processes of their own while
/// golden and reference run in this one. Throws golden::InputError.
[[nodiscard]] SceneRun run_scene(const golden::Scene& scene);

}  // namespace ptm::testbench
