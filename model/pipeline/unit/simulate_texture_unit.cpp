#include "model/pipeline/simulate_texture_unit.h"

#include "model/pipeline/elaborated.h"
#include "model/pipeline/unit/memory_target.h"
#include "model/pipeline/unit/texture_unit.h"

namespace ptm::pipeline {
namespace {

/// The only process of the model: it runs frame after frame and lets time catch up.
class UnitSource final : public sc_core::sc_module {
 public:
  SC_HAS_PROCESS(UnitSource);
  UnitSource(const sc_core::sc_module_name& name, const UnitSimulation& simulation,
             TextureUnit& unit, MemoryTarget& memory, const sc_core::sc_time& clock)
      : sc_module(name), simulation_(simulation), unit_(unit), memory_(memory), clock_(clock) {
    SC_THREAD(run);
  }

 private:
  void run() {
    for (std::size_t n = 0; n < simulation_.frames.count; ++n) {
      memory_.reset();
      TextureUnit::Frame frame = unit_.run(simulation_.frames.make(n), simulation_.patience);
      wait(sc_core::sc_time::from_value(frame.end * clock_.value()));
      const bool ended = frame.result.fault.has_value();
      simulation_.frames.take(n, std::move(frame.result));
      if (ended) return;
    }
  }

  const UnitSimulation& simulation_;
  TextureUnit& unit_;
  MemoryTarget& memory_;
  sc_core::sc_time clock_;
};

}  // namespace

void simulate_texture_unit(const UnitSimulation& simulation) {
  reference::validate(simulation.unit);
  const sc_core::sc_time clock(1, sc_core::SC_NS);
  MemoryTarget memory("memory", make_memory(simulation.memory), simulation.state->memory, clock,
                      simulation.state->base);
  TextureUnit unit("unit", simulation.unit, simulation.state->draws, simulation.timing,
                   simulation.fault, clock, simulation.eval);
  unit.memory.set_base(simulation.state->base);
  unit.memory.socket.bind(memory.socket);
  UnitSource source("source", simulation, unit, memory, clock);
  if (simulation.elaborated) simulation.elaborated(module_names(elaborated()));
  // Warnings are errors: a model that SystemC doubts is not a model to quote.
  sc_core::sc_report_handler::set_actions(sc_core::SC_WARNING, sc_core::SC_THROW);
  sc_core::sc_start();
}

}  // namespace ptm::pipeline
