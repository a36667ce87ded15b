#pragma once
#include "model/pipeline/simulate_texture_unit.h"
#include "testbench/run/unit_job.h"

/// The verilated units that come with the build (testbench/rtl).
namespace ptm::testbench {

/// Throws golden::InputError at the scene's [hardware] if no unit was verilated with its
/// parameters; the error lists those that were.
void check_unit_variant(const UnitJob& job);

/// Draws the simulation's frames with the RTL, pixels included.
void simulate_unit_rtl(const UnitJob& job, const pipeline::UnitSimulation& simulation);

}  // namespace ptm::testbench
