#include "model/pipeline/unit/shared_memory.h"

#include <algorithm>

namespace ptm::pipeline {

NbAdapter::NbAdapter(const sc_core::sc_module_name& name, const sc_core::sc_time& patience)
    : sc_module(name), patience_(patience) {
  in.register_b_transport(this, &NbAdapter::b_transport);
  out.register_nb_transport_bw(this, &NbAdapter::nb_transport_bw);
}

void NbAdapter::b_transport(Payload& payload, sc_core::sc_time& delay) {
  if (silent_) {
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
    delay = sc_core::sc_max_time();
    return;
  }
  wait(delay);
  delay = sc_core::SC_ZERO_TIME;
  auto* sent = new Payload(this);
  sent->acquire();
  sent->set_command(payload.get_command());
  sent->set_address(payload.get_address());
  sent->set_data_ptr(payload.get_data_ptr());
  sent->set_data_length(payload.get_data_length());
  sent->set_streaming_width(payload.get_streaming_width());
  sent->set_byte_enable_ptr(payload.get_byte_enable_ptr());
  sent->set_byte_enable_length(payload.get_byte_enable_length());
  if (exchange(*sent, delay)) {
    payload.set_response_status(sent->get_response_status());
  } else {
    payload.set_response_status(tlm::TLM_OK_RESPONSE);  // what is wrong is the time it takes
    delay = sc_core::sc_max_time();
  }
  sent->release();
}

/// BEGIN_REQ to END_RESP; false if no response came.
bool NbAdapter::exchange(Payload& sent, sc_core::sc_time& delay) {
  tlm::tlm_phase phase = tlm::BEGIN_REQ;
  waiting_ = &sent;
  const tlm::tlm_sync_enum answer = out->nb_transport_fw(sent, phase, delay);
  if (answer == tlm::TLM_COMPLETED) {
    waiting_ = nullptr;
    return true;
  }
  if (answer != tlm::TLM_UPDATED || phase != tlm::BEGIN_RESP) {
    if (waiting_ != nullptr) wait(patience_, responded_);
    if (waiting_ != nullptr) {
      sent.acquire();  // the target may still hold it: it is not ours to free
      waiting_ = nullptr;
      silent_ = true;
      return false;
    }
    delay = response_delay_;
  }
  waiting_ = nullptr;
  phase = tlm::END_RESP;
  sc_core::sc_time end = delay;
  out->nb_transport_fw(sent, phase, end);
  return true;
}

tlm::tlm_sync_enum NbAdapter::nb_transport_bw(Payload& payload, tlm::tlm_phase& phase,
                                              sc_core::sc_time& delay) {
  if (phase == tlm::BEGIN_RESP && &payload == waiting_) {
    waiting_ = nullptr;
    response_delay_ = delay;
    responded_.notify(sc_core::SC_ZERO_TIME);
  }
  return tlm::TLM_ACCEPTED;
}

Interconnect::Interconnect(const sc_core::sc_module_name& name, const sc_core::sc_time& clock)
    : sc_module(name), clock_(clock) {
  in.register_nb_transport_fw(this, &Interconnect::nb_transport_fw);
  out.register_nb_transport_bw(this, &Interconnect::nb_transport_bw);
}

tlm::tlm_sync_enum Interconnect::nb_transport_fw(int from, Payload& payload, tlm::tlm_phase& phase,
                                                 sc_core::sc_time& delay) {
  if (phase == tlm::BEGIN_REQ) {
    const sc_core::sc_time now = sc_core::sc_time_stamp();
    const sc_core::sc_time passes = std::max(now + delay, free_);
    free_ = passes + clock_;
    delay = passes - now;
    from_[&payload] = from;
  }
  const bool ends = phase == tlm::END_RESP;
  const tlm::tlm_sync_enum answer = out->nb_transport_fw(payload, phase, delay);
  if (ends || answer == tlm::TLM_COMPLETED) from_.erase(&payload);
  return answer;
}

tlm::tlm_sync_enum Interconnect::nb_transport_bw(Payload& payload, tlm::tlm_phase& phase,
                                                 sc_core::sc_time& delay) {
  const auto from = from_.find(&payload);
  if (from == from_.end()) {
    SC_REPORT_ERROR(name(), "a phase of a transaction that nobody sent");
    return tlm::TLM_ACCEPTED;
  }
  const tlm::tlm_sync_enum answer = in[from->second]->nb_transport_bw(payload, phase, delay);
  if (answer == tlm::TLM_COMPLETED) from_.erase(&payload);
  return answer;
}

}  // namespace ptm::pipeline
