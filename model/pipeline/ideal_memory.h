#pragma once
#include <tlm_utils/multi_passthrough_target_socket.h>

#include <cstdint>
#include <cstring>
#include <span>
#include <systemc>
#include <tlm>

namespace ptm::pipeline {

/// A memory that answers every TMU in the cycle after the request, whatever the address.
///
/// Protocol  TLM-2.0 b_transport; reads of one aligned 32-bit word, little-endian. The annotated
///           delay grows by one clock. Other commands, lengths, byte enables and addresses beyond
///           the end get the error response that TLM-2.0 names for them.
class IdealMemory final : public sc_core::sc_module {
 public:
  tlm_utils::multi_passthrough_target_socket<IdealMemory> socket{"socket"};

  IdealMemory(const sc_core::sc_module_name& name, std::span<const std::uint32_t> words,
              const sc_core::sc_time& clock)
      : sc_module(name), words_(words), clock_(clock) {
    socket.register_b_transport(this, &IdealMemory::b_transport);
  }

 private:
  void b_transport(int, tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    payload.set_response_status(read(payload));
    delay += clock_;
  }

  tlm::tlm_response_status read(tlm::tlm_generic_payload& payload) const {
    if (!payload.is_read()) return tlm::TLM_COMMAND_ERROR_RESPONSE;
    if (payload.get_data_length() != 4 || payload.get_streaming_width() < 4) {
      return tlm::TLM_BURST_ERROR_RESPONSE;
    }
    if (payload.get_byte_enable_ptr() != nullptr) return tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE;
    const std::uint64_t address = payload.get_address();
    if (address % 4 != 0 || address / 4 >= words_.size()) return tlm::TLM_ADDRESS_ERROR_RESPONSE;
    std::memcpy(payload.get_data_ptr(), &words_[address / 4], 4);
    return tlm::TLM_OK_RESPONSE;
  }

  std::span<const std::uint32_t> words_;
  sc_core::sc_time clock_;
};

}  // namespace ptm::pipeline
