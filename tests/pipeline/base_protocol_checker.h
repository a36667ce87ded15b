#pragma once
#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

#include <map>
#include <string>
#include <systemc>
#include <tlm>
#include <vector>

namespace ptm::tests {

/// Stands on a link and writes down what the TLM-2.0 base protocol forbids (IEEE 1666-2011, 14 and
/// 15): phases out of order, a second request or response before the first one's end, attributes
/// missing, changed on the way or with a response already set, extensions, transactions without a
/// memory manager. Passes everything on unchanged.
class BaseProtocolChecker final : public sc_core::sc_module {
 public:
  using Payload = tlm::tlm_generic_payload;
  tlm_utils::simple_target_socket<BaseProtocolChecker> in{"in"};
  tlm_utils::simple_initiator_socket<BaseProtocolChecker> out{"out"};

  std::vector<std::string> violations;
  std::uint64_t transactions = 0;

  explicit BaseProtocolChecker(const sc_core::sc_module_name& name) : sc_module(name) {
    in.register_b_transport(this, &BaseProtocolChecker::b_transport);
    in.register_nb_transport_fw(this, &BaseProtocolChecker::nb_transport_fw);
    out.register_nb_transport_bw(this, &BaseProtocolChecker::nb_transport_bw);
  }

 private:
  struct Attributes {
    tlm::tlm_command command;
    std::uint64_t address;
    unsigned char* data;
    unsigned length, width;
    bool operator==(const Attributes&) const = default;
  };
  struct Transaction {
    tlm::tlm_phase_enum phase = tlm::UNINITIALIZED_PHASE;
    Attributes sent;
  };

  void require(bool holds, const char* rule) {
    if (!holds) violations.emplace_back(rule);
  }

  [[nodiscard]] static Attributes attributes(const Payload& p) {
    return {p.get_command(), p.get_address(), p.get_data_ptr(), p.get_data_length(),
            p.get_streaming_width()};
  }

  Attributes begin(const Payload& p) {
    ++transactions;
    require(p.get_response_status() == tlm::TLM_INCOMPLETE_RESPONSE,
            "a request's response status is not TLM_INCOMPLETE_RESPONSE");
    require(!p.is_dmi_allowed(), "a request allows DMI");
    require(p.get_data_ptr() != nullptr, "a request has no data pointer");
    require(p.get_data_length() != 0, "a request has no length");
    require(p.get_streaming_width() != 0, "a request's streaming width is 0");
    for (unsigned n = 0; n < tlm::max_num_extensions(); ++n) {
      require(p.get_extension(n) == nullptr, "a request carries an extension");
    }
    return attributes(p);
  }
  void respond(const Payload& p, const Attributes& sent) {
    require(attributes(p) == sent, "an attribute changed on the way");
    require(p.get_response_status() != tlm::TLM_INCOMPLETE_RESPONSE,
            "a response has no response status");
  }

  void b_transport(Payload& payload, sc_core::sc_time& delay) {
    const Attributes sent = begin(payload);
    const sc_core::sc_time asked = sc_core::sc_time_stamp() + delay;
    out->b_transport(payload, delay);
    respond(payload, sent);
    require(delay == sc_core::sc_max_time() || sc_core::sc_time_stamp() + delay >= asked,
            "b_transport goes back in time");
  }

  tlm::tlm_sync_enum nb_transport_fw(Payload& payload, tlm::tlm_phase& phase,
                                     sc_core::sc_time& delay) {
    step(payload, phase, true);
    const tlm::tlm_phase_enum called = static_cast<tlm::tlm_phase_enum>(unsigned{phase});
    const sc_core::sc_time before = delay;
    const auto answer = out->nb_transport_fw(payload, phase, delay);
    take_answer(payload, phase, answer, called, false);
    require(delay >= before, "nb_transport_fw goes back in time");
    return answer;
  }

  tlm::tlm_sync_enum nb_transport_bw(Payload& payload, tlm::tlm_phase& phase,
                                     sc_core::sc_time& delay) {
    step(payload, phase, false);
    const tlm::tlm_phase_enum called = static_cast<tlm::tlm_phase_enum>(unsigned{phase});
    const auto answer = in->nb_transport_bw(payload, phase, delay);
    take_answer(payload, phase, answer, called, true);
    return answer;
  }

  /// A phase sent by the initiator (in a forward call or a backward return) or by the target.
  void step(Payload& payload, const tlm::tlm_phase& sent, bool initiator) {
    const auto phase = static_cast<tlm::tlm_phase_enum>(unsigned{sent});
    if (phase == tlm::BEGIN_REQ) {
      require(initiator, "a target sends BEGIN_REQ");
      require(!open_.contains(&payload), "BEGIN_REQ of a transaction under way");
      require(requesting_ == nullptr, "BEGIN_REQ before the last request's end");
      require(payload.has_mm() && payload.get_ref_count() > 0, "no memory manager");
      requesting_ = &payload;
      open_[&payload] = {phase, begin(payload)};
      return;
    }
    const auto at = open_.find(&payload);
    if (at == open_.end()) return require(false, "a phase of a transaction not under way");
    tlm::tlm_phase_enum& now = at->second.phase;
    if (phase == tlm::END_REQ) {
      require(!initiator && now == tlm::BEGIN_REQ, "END_REQ out of order");
      requesting_ = nullptr;
    } else if (phase == tlm::BEGIN_RESP) {
      require(!initiator && (now == tlm::BEGIN_REQ || now == tlm::END_REQ),
              "BEGIN_RESP out of order");
      require(responding_ == nullptr, "BEGIN_RESP before the last response's end");
      if (requesting_ == &payload) requesting_ = nullptr;
      responding_ = &payload;
      respond(payload, at->second.sent);
    } else if (phase == tlm::END_RESP) {
      require(initiator && now == tlm::BEGIN_RESP, "END_RESP out of order");
      close(&payload);
      return;
    } else {
      require(false, "a phase that the base protocol does not have");
    }
    now = phase;
  }

  void take_answer(Payload& payload, const tlm::tlm_phase& phase, tlm::tlm_sync_enum answer,
                   tlm::tlm_phase_enum called, bool initiator) {
    if (answer == tlm::TLM_UPDATED) {
      require(unsigned{phase} != unsigned{called}, "TLM_UPDATED without a new phase");
      step(payload, phase, initiator);
    } else if (answer == tlm::TLM_COMPLETED && called != tlm::END_RESP) {
      if (const auto at = open_.find(&payload); at != open_.end()) {
        respond(payload, at->second.sent);
      }
      close(&payload);
    }
  }

  void close(Payload* payload) {
    open_.erase(payload);
    if (requesting_ == payload) requesting_ = nullptr;
    if (responding_ == payload) responding_ = nullptr;
  }

  std::map<Payload*, Transaction> open_;
  Payload* requesting_ = nullptr;
  Payload* responding_ = nullptr;
};

}  // namespace ptm::tests
