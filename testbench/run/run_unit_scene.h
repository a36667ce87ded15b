#pragma once
#include "golden/scene/unit_scene.h"
#include "testbench/run/run_scene.h"
#include "testbench/run/unit_models.h"

namespace ptm::testbench {

/// Draws a scene through the whole unit with each model that it names. Throws golden::InputError.
[[nodiscard]] SceneRun run_unit_scene(const golden::UnitScene& scene);

/// Pixels that two timed models let go in different cycles, over all frames; frames of different
/// length count as wholly different.
[[nodiscard]] std::uint64_t count_late_pixels(const UnitTimed& a, const UnitTimed& b);
/// Names of the counters in which two timed models differ in any frame.
[[nodiscard]] std::vector<std::string> differing_counters(const UnitTimed& a, const UnitTimed& b);

/// Cycles a pixel of a draw whose lines are all hits: docs/spec/unit-timing.md. Footprints and
/// probes are the frame's mean.
[[nodiscard]] double warm_cycles_per_pixel(const UnitJob& job, int draw);

}  // namespace ptm::testbench
