#include "testbench/run/unit_rtl.h"

#include "testbench/rtl/unit_variants.h"

namespace ptm::testbench {

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
