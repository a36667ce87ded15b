#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "testbench/run/run_result.h"
#include "testbench/run/unit_models.h"

/// What a run of the whole unit says of time.
namespace ptm::testbench {

/// Over all frames.
[[nodiscard]] reference::UnitCounters total_counters(const UnitTimed& timed);

/// Pixels that two timed models let go in different cycles, over all frames; frames of different
/// length count as wholly different.
[[nodiscard]] std::uint64_t count_late_pixels(const UnitTimed& a, const UnitTimed& b);
/// Names of the counters in which two timed models differ in any frame; a frame that one of them
/// lacks counts as one of zeros.
[[nodiscard]] std::vector<std::string> differing_counters(const UnitTimed& a, const UnitTimed& b);

/// Cycles a pixel of a draw whose lines are all hits: docs/spec/unit-timing.md. Footprints and
/// probes are the frame's mean.
[[nodiscard]] double warm_cycles_per_pixel(const UnitJob& job, int draw);

/// The report's section; pipeline and rtl are compared if both are there.
[[nodiscard]] UnitSection make_unit_section(const UnitJob& job,
                                            const std::vector<UnitTimed>& timed);

}  // namespace ptm::testbench
