#pragma once
#include "model/pipeline/simulate_texture_unit.h"
#include "testbench/run/unit_job.h"

/// The RTL unit with a scene's parameters.
namespace ptm::testbench {

/// Draws the simulation's frames with the RTL, pixels included.
void simulate_unit_rtl(const UnitJob& job, const pipeline::UnitSimulation& simulation);

}  // namespace ptm::testbench
