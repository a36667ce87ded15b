#pragma once
#include <functional>
#include <optional>

#include "model/pipeline/unit_run.h"

/// The whole texture unit in time, free of SystemC's headers. Pixel values are the reference's
/// (model/reference/unit/shade.h); these models own time and counters.
namespace ptm::pipeline {

/// The frames that a unit draws: made and taken one at a time, so that memory stays bounded. What
/// `make` returns must live until `take` was called with that frame's result.
struct UnitFrameStream {
  std::size_t count = 0;
  std::function<UnitFrame(std::size_t frame)> make;
  std::function<void(std::size_t frame, UnitFrameResult&& result)> take;
};

struct UnitSimulation {
  reference::UnitConfig unit;
  reference::EvalConfig eval;  ///< only multiplies_effects looks at it
  /// Draws and memory. An empty memory answers with nothing but its time: enough for all that these
  /// models give, since their pixels are the reference's.
  const reference::UnitState* state = nullptr;
  UnitFrameStream frames;
  StreamTiming timing;
  MemoryModel memory = FixedMemory{};
  std::optional<MemoryFault> fault;
  Cycle patience = kPatience;
  /// If set, told the names of the SystemC modules that were elaborated for this run, before it.
  std::function<void(const std::vector<std::string>& modules)> elaborated;
};

/// Timing `exact`: every pixel's cycle and every counter are the RTL's (docs/spec/unit-timing.md).
/// SystemC elaborates once a process: call it once, in a process of its own
/// (testbench/run/child_process.h).
/// Requires legal draws (check_draw) and fragments that name one of them. Throws
/// std::invalid_argument for an illegal configuration or memory; a memory that answers with a
/// TLM error ends the simulation with sc_core::sc_report. A fault (MemoryFault) is a result; its
/// counters 2 to 7 are 0, the others those of all that was sent on its way.
void simulate_texture_unit(const UnitSimulation& simulation);

}  // namespace ptm::pipeline
