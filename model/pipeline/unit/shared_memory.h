#pragma once
#include <tlm_utils/multi_passthrough_target_socket.h>
#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

#include <map>
#include <systemc>
#include <tlm>

/// For platforms in which units share a memory: requests meet in the order of simulated time.
namespace ptm::pipeline {

/// From a unit's b_transport to nb_transport: lets simulated time come to the request's cycle
/// (other initiators run meanwhile), then sends it with BEGIN_REQ.
///
/// Protocol  base protocol, one transaction at a time, with a memory manager. A target that answers
///           in its return path (TLM_COMPLETED, or BEGIN_RESP with an annotated delay, as
///           MemoryTarget does) leaves the unit its cycles: the next request leaves before this one
///           is answered. One that answers by nb_transport_bw is waited for, so such requests do
///           not overlap.
/// Faults    no response within `patience` of simulated time gives a delay of sc_max_time(); so
/// does
///           every later request, which must not be sent while that one is open.
class NbAdapter final : public sc_core::sc_module, private tlm::tlm_mm_interface {
 public:
  tlm_utils::simple_target_socket<NbAdapter> in{"in"};
  tlm_utils::simple_initiator_socket<NbAdapter> out{"out"};

  NbAdapter(const sc_core::sc_module_name& name, const sc_core::sc_time& patience);

 private:
  using Payload = tlm::tlm_generic_payload;

  void b_transport(Payload& payload, sc_core::sc_time& delay);
  tlm::tlm_sync_enum nb_transport_bw(Payload& payload, tlm::tlm_phase& phase,
                                     sc_core::sc_time& delay);
  [[nodiscard]] bool exchange(Payload& sent, sc_core::sc_time& delay);
  void free(Payload* payload) override { delete payload; }

  sc_core::sc_time patience_;
  sc_core::sc_event responded_;
  Payload* waiting_ = nullptr;
  bool silent_ = false;  ///< the target has not answered in time
  sc_core::sc_time response_delay_;
};

/// Many initiators, one target: passes one request a clock in order of arrival.
///
/// Protocol  base protocol, nb_transport only. A request that comes while the one before it takes
///           its clock is delayed by annotation. Responses go back to whoever asked.
class Interconnect final : public sc_core::sc_module {
 public:
  tlm_utils::multi_passthrough_target_socket<Interconnect> in{"in"};
  tlm_utils::simple_initiator_socket<Interconnect> out{"out"};

  Interconnect(const sc_core::sc_module_name& name, const sc_core::sc_time& clock);

 private:
  using Payload = tlm::tlm_generic_payload;

  tlm::tlm_sync_enum nb_transport_fw(int from, Payload& payload, tlm::tlm_phase& phase,
                                     sc_core::sc_time& delay);
  tlm::tlm_sync_enum nb_transport_bw(Payload& payload, tlm::tlm_phase& phase,
                                     sc_core::sc_time& delay);

  sc_core::sc_time clock_, free_;
  std::map<Payload*, int> from_;  ///< of each transaction under way
};

}  // namespace ptm::pipeline
