#pragma once
#include "golden/scene/unit_scene.h"
#include "testbench/run/run_scene.h"
#include "testbench/run/unit_models.h"

namespace ptm::testbench {

/// Draws a scene through the whole unit with each model that it names. Throws golden::InputError.
[[nodiscard]] SceneRun run_unit_scene(const golden::UnitScene& scene);

}  // namespace ptm::testbench
