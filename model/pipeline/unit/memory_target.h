#pragma once
#include <tlm_utils/simple_target_socket.h>

#include <memory>
#include <span>
#include <systemc>
#include <tlm>

#include "model/pipeline/memory_timing.h"
#include "model/reference/unit/unit_memory.h"

namespace ptm::pipeline {

/// Lines of memory behind a TLM-2.0 socket, answering when a MemoryTiming says.
///
/// Protocol  base protocol, b_transport and nb_transport: reads of one aligned line of 64 bytes;
///           a request's cycle is the simulation time plus the annotated delay. b_transport returns
///           the response's time as delay, nb_transport BEGIN_RESP with it in its return path; the
///           response's end is taken at once. Other commands, lengths, byte enables and addresses
///           beyond the end get the error response that TLM-2.0 names for them. No DMI.
/// Faults    a timing that answers kNever gives a delay of sc_max_time(), or TLM_ACCEPTED and no
///           response at all.
/// Time      requests come in the order of their cycles; reset() begins a frame, cycle 0 is now.
/// Lines     the span may be empty: then there is no end, and no data are given.
class MemoryTarget final : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket<MemoryTarget> socket{"socket"};

  /// `first`: the line address of lines[0]; the others follow, modulo 2^26.
  MemoryTarget(const sc_core::sc_module_name& name, std::unique_ptr<MemoryTiming> timing,
               std::span<const reference::Line> lines, const sc_core::sc_time& clock,
               std::uint32_t first = 0);

  void reset();

 private:
  void b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  tlm::tlm_sync_enum nb_transport_fw(tlm::tlm_generic_payload& payload, tlm::tlm_phase& phase,
                                     sc_core::sc_time& delay);
  [[nodiscard]] tlm::tlm_response_status read(tlm::tlm_generic_payload& payload) const;
  [[nodiscard]] bool answer(const tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);

  std::unique_ptr<MemoryTiming> timing_;
  std::span<const reference::Line> lines_;
  std::uint32_t first_;
  sc_core::sc_time clock_, origin_;
  std::uint64_t index_ = 0;
};

}  // namespace ptm::pipeline
