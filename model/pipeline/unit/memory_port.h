#pragma once
#include <tlm_utils/simple_initiator_socket.h>

#include <optional>
#include <systemc>
#include <tlm>
#include <vector>

#include "model/pipeline/unit/unit_beat.h"
#include "model/pipeline/unit_run.h"
#include "model/reference/unit/unit_memory.h"

namespace ptm::pipeline {

/// The unit's way to memory.
///
/// Protocol  TLM-2.0 base protocol, b_transport: reads of one aligned line of 64 bytes, in request
///           order. The annotated delay is the request's cycle when the call is made (counted from
///           the simulation time at which the frame began) and the response's when it returns.
///           sc_max_time() says that no response ever comes.
/// Bad input a response status other than OK is an SC_ERROR with the address.
class MemoryPort final : public sc_core::sc_module {
 public:
  tlm_utils::simple_initiator_socket<MemoryPort> socket{"socket"};

  MemoryPort(const sc_core::sc_module_name& name, const sc_core::sc_time& clock,
             const std::optional<MemoryFault>& fault);

  /// A line is asked for in `cycle`; returns the cycle from which it may be committed, kStuck for
  /// never. `slot` is the request's tag.
  Cycle read(std::uint32_t line, Cycle cycle, std::uint32_t slot, const UnitBeat& beat);

  /// The unit's line l is the memory's outer_line(base, l).
  void set_base(std::uint32_t base) { base_ = base; }

  /// A frame begins at this simulation time.
  void reset();

  /// What is known of a fault: the request that was not answered as it should.
  struct Waiting {
    MemoryFault::Kind kind = MemoryFault::Kind::never;
    std::uint64_t index = 0;
    std::uint32_t line = 0, slot = 0;
    Cycle answered = 0;  ///< wrong_tag: the cycle of that response
    std::uint16_t x = 0, y = 0;
  };
  [[nodiscard]] const std::optional<Waiting>& waiting() const { return waiting_; }
  /// The last transfer of a request or a response.
  [[nodiscard]] Cycle last_transfer() const { return last_transfer_; }

  std::vector<Cycle> answered;  ///< cycle of each response, in request order

 private:
  [[nodiscard]] Cycle transport(std::uint32_t line, Cycle cycle);
  void note_fault(MemoryFault::Kind kind, std::uint32_t line, std::uint32_t slot, Cycle done,
                  const UnitBeat& beat);

  sc_core::sc_time clock_;
  std::optional<MemoryFault> fault_;
  std::optional<Waiting> waiting_;
  std::uint32_t base_ = 0;
  std::uint64_t index_ = 0;  ///< of the next request, from reset
  sc_core::sc_time origin_;
  Cycle last_transfer_ = 0;
  reference::Line data_{};
  tlm::tlm_generic_payload payload_;
};

}  // namespace ptm::pipeline
