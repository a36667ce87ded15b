#include "testbench/run/unit_rtl.h"

#include <stdexcept>

#include "testbench/rtl/verilated_unit.h"

namespace ptm::testbench {

void check_unit_variant(const UnitJob& job) {
  try {
    (void)make_rtl_unit(job.config, job.unit);
  } catch (const std::invalid_argument& error) {
    const golden::HardwareSpec& hardware = job.scene.hardware;
    const std::string what = error.what(), before = "there is: ";
    const std::size_t list = what.find(before);
    throw golden::InputError(
        job.scene.file.string(), hardware.place.empty() ? "the file" : hardware.place,
        "parameters that no RTL unit is built with",
        "models without rtl, or one of " +
            (list == std::string::npos ? what : what.substr(list + before.size())));
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
