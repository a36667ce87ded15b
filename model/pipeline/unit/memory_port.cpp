#include "model/pipeline/unit/memory_port.h"

#include <algorithm>
#include <string>

namespace ptm::pipeline {

MemoryPort::MemoryPort(const sc_core::sc_module_name& name, const sc_core::sc_time& clock,
                       const std::optional<MemoryFault>& fault)
    : sc_module(name), clock_(clock), fault_(fault) {
  payload_.set_command(tlm::TLM_READ_COMMAND);
  payload_.set_data_length(sizeof data_);
  payload_.set_streaming_width(sizeof data_);
  payload_.set_byte_enable_ptr(nullptr);
}

void MemoryPort::reset() {
  waiting_.reset();
  index_ = 0;
  origin_ = sc_core::sc_time_stamp();
  last_transfer_ = 0;
  answered.clear();
}

/// The cycle of the response, kNever for none.
Cycle MemoryPort::transport(std::uint32_t line, Cycle cycle) {
  const std::uint64_t address = std::uint64_t{line} * sizeof data_;
  payload_.set_address(address);
  payload_.set_data_ptr(reinterpret_cast<unsigned char*>(data_.data()));
  payload_.set_dmi_allowed(false);
  payload_.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  // A target may let time pass instead of annotating it: what counts is the time from `origin_`.
  const std::uint64_t now = sc_core::sc_time_stamp().value() - origin_.value();
  const std::uint64_t asked = std::max<std::uint64_t>(cycle * clock_.value(), now);
  sc_core::sc_time delay = sc_core::sc_time::from_value(asked - now);
  socket->b_transport(payload_, delay);
  if (!payload_.is_response_ok()) {
    SC_REPORT_ERROR(name(), ("memory answers " + payload_.get_response_string() + " at byte " +
                             std::to_string(address))
                                .c_str());
  }
  if (delay == sc_core::sc_max_time()) return kNever;
  const std::uint64_t since = sc_core::sc_time_stamp().value() - origin_.value() + delay.value();
  return since / clock_.value();
}

void MemoryPort::note_fault(MemoryFault::Kind kind, std::uint32_t line, std::uint32_t slot,
                            Cycle done, const UnitBeat& beat) {
  if (waiting_) return;
  waiting_ = {kind, index_, line, slot, done, beat.fragment->x, beat.fragment->y};
}

Cycle MemoryPort::read(std::uint32_t line, Cycle cycle, std::uint32_t slot, const UnitBeat& beat) {
  if (cycle >= kStuck) return kStuck;  // behind a fault; nobody sends it
  Cycle done = transport(reference::outer_line(base_, line), cycle);
  if (fault_ && fault_->index == index_ && fault_->kind == MemoryFault::Kind::never) done = kNever;
  answered.push_back(done);
  last_transfer_ = std::max(last_transfer_, done == kNever ? cycle : done);
  Cycle usable = done + 2;
  if (done == kNever) {
    note_fault(MemoryFault::Kind::never, line, slot, done, beat);
    usable = kStuck;
  } else if (fault_ && fault_->index == index_) {
    note_fault(MemoryFault::Kind::wrong_tag, line, slot, done, beat);
    usable = kStuck;  // the response is dropped
  }
  ++index_;
  return usable;
}

}  // namespace ptm::pipeline
