#include "testbench/run/unit_rtl.h"

#include <iostream>

#include "testbench/program/exit_code.h"
#include "testbench/rtl/unit_variants.h"
#include "testbench/rtl/variant_cache.h"

namespace ptm::testbench {

void prepare_unit_variant(const UnitJob& job) {
  if (find_rtl_unit_variant(job.config, job.unit)) return;
  try {
    (void)build_variant(job.config, job.unit,
                        [](const std::string& what) { std::cerr << "ptmsim: " << what << '\n'; });
  } catch (const ToolError& error) {
    throw ExitError(ExitCode::missing_tool, error.what());
  } catch (const UnusableCache& error) {
    throw golden::InputError(error.folder, "$PTMSIM_CACHE", error.reason,
                             "a folder that can be written, for units that are built");
  }
}

void simulate_unit_rtl(const UnitJob& job, const pipeline::UnitSimulation& simulation) {
  const auto rtl = make_rtl_unit(job.config, job.unit);
  const auto memory = pipeline::make_memory(simulation.memory);
  rtl->load(job.state);
  for (std::size_t n = 0; n < simulation.frames.count; ++n) {
    pipeline::UnitFrameResult result =
        rtl->run(simulation.frames.make(n), *memory, simulation.timing, simulation.fault);
    const bool ended = result.fault.has_value();
    simulation.frames.take(n, std::move(result));
    if (ended) return;
  }
}

}  // namespace ptm::testbench
