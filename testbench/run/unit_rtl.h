#pragma once
#include "model/pipeline/simulate_texture_unit.h"
#include "testbench/run/unit_job.h"

/// The RTL unit with a scene's parameters.
namespace ptm::testbench {

/// Sees to it that there is a unit with the job's parameters, in a process that may still start
/// others: builds one that does not come with the build and says so on the terminal. Throws
/// ExitError (a needed tool is missing).
void prepare_unit_variant(const UnitJob& job);

/// Draws the simulation's frames with the RTL, pixels included.
void simulate_unit_rtl(const UnitJob& job, const pipeline::UnitSimulation& simulation);

}  // namespace ptm::testbench
