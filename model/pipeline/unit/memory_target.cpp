#include "model/pipeline/unit/memory_target.h"

#include <cstring>

namespace ptm::pipeline {
namespace {

constexpr std::uint64_t kLineBytes = sizeof(reference::Line);

}  // namespace

MemoryTarget::MemoryTarget(const sc_core::sc_module_name& name,
                           std::unique_ptr<MemoryTiming> timing,
                           std::span<const reference::Line> lines, const sc_core::sc_time& clock,
                           std::uint32_t first)
    : sc_module(name), timing_(std::move(timing)), lines_(lines), first_(first), clock_(clock) {
  socket.register_b_transport(this, &MemoryTarget::b_transport);
  socket.register_nb_transport_fw(this, &MemoryTarget::nb_transport_fw);
}

void MemoryTarget::reset() {
  timing_->reset();
  origin_ = sc_core::sc_time_stamp();
  index_ = 0;
}

tlm::tlm_response_status MemoryTarget::read(tlm::tlm_generic_payload& payload) const {
  if (!payload.is_read()) return tlm::TLM_COMMAND_ERROR_RESPONSE;
  if (payload.get_data_length() != kLineBytes || payload.get_streaming_width() < kLineBytes) {
    return tlm::TLM_BURST_ERROR_RESPONSE;
  }
  if (payload.get_byte_enable_ptr() != nullptr) return tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE;
  const std::uint64_t address = payload.get_address();
  if (address % kLineBytes != 0) return tlm::TLM_ADDRESS_ERROR_RESPONSE;
  if (lines_.empty()) return tlm::TLM_OK_RESPONSE;
  if (address / kLineBytes > reference::kOuterMask) return tlm::TLM_ADDRESS_ERROR_RESPONSE;
  const std::uint32_t line = static_cast<std::uint32_t>(address / kLineBytes) - first_;
  if ((line & reference::kOuterMask) >= lines_.size()) return tlm::TLM_ADDRESS_ERROR_RESPONSE;
  std::memcpy(payload.get_data_ptr(), lines_[line & reference::kOuterMask].data(), kLineBytes);
  return tlm::TLM_OK_RESPONSE;
}

/// Moves `delay` from the request's time to the response's; false if none ever comes.
bool MemoryTarget::answer(const tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  const std::uint64_t now = sc_core::sc_time_stamp().value() - origin_.value();
  const Cycle asked = (now + delay.value()) / clock_.value();
  const auto line = static_cast<std::uint32_t>(payload.get_address() / kLineBytes);
  const Cycle done = timing_->line(index_++, line, asked);
  if (done == kNever) return false;
  delay = sc_core::sc_time::from_value(done * clock_.value() - now);
  return true;
}

void MemoryTarget::b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  payload.set_response_status(read(payload));
  if (payload.is_response_ok() && !answer(payload, delay)) delay = sc_core::sc_max_time();
}

tlm::tlm_sync_enum MemoryTarget::nb_transport_fw(tlm::tlm_generic_payload& payload,
                                                 tlm::tlm_phase& phase, sc_core::sc_time& delay) {
  if (phase == tlm::END_RESP) return tlm::TLM_COMPLETED;
  if (phase != tlm::BEGIN_REQ) {
    SC_REPORT_ERROR(name(), "a phase that no initiator sends");
    return tlm::TLM_ACCEPTED;
  }
  payload.set_response_status(read(payload));
  if (payload.is_response_ok() && !answer(payload, delay)) return tlm::TLM_ACCEPTED;
  phase = tlm::BEGIN_RESP;
  return tlm::TLM_UPDATED;
}

}  // namespace ptm::pipeline
