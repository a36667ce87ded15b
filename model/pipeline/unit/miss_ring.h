#pragma once
#include <algorithm>
#include <vector>

#include "model/pipeline/unit/commit.h"
#include "model/pipeline/unit/memory_port.h"

namespace ptm::pipeline {

/// Slots for lines reserved or outstanding, in the order (beat, rank, TMU), and their requests,
/// one a cycle in that order.
class MissRing final : public sc_core::sc_module {
 public:
  MissRing(const sc_core::sc_module_name& name, MemoryPort& memory, int slots)
      : sc_module(name),
        memory_(memory),
        free_(static_cast<std::size_t>(slots)),
        tags_((static_cast<std::uint32_t>(slots) + 3) / 4 * 4) {}

  /// From when on `count` slots are free together: the last of them is, they return in order.
  [[nodiscard]] Cycle available(unsigned count) const {
    return free_[(next_ + count - 1) % free_.size()];
  }
  /// The next slot is taken and its line asked for; returns from when on it may be committed.
  Cycle push(std::uint32_t line, Cycle pushed, const UnitBeat& beat) {
    const Cycle sent = std::max(pushed + 1, request_free_);
    request_free_ = sent + 1;
    if (sent < kStuck) ++requests_;
    const std::uint32_t tag = next_tag_;
    next_tag_ = (next_tag_ + 1) % tags_;
    next_ = (next_ + 1) % free_.size();
    ++held_;
    return memory_.read(line, sent, tag, beat);
  }
  /// The beat that pushed since the last release has left K.
  void release(Cycle left) {
    for (; held_ != 0; --held_) free_[(next_ + free_.size() - held_) % free_.size()] = left + 1;
  }

  /// `first_request`: nothing is asked for before that cycle.
  void reset(Cycle first_request) {
    std::fill(free_.begin(), free_.end(), 0);
    next_ = held_ = 0;
    next_tag_ = 0;
    requests_ = 0;
    request_free_ = first_request;
  }
  [[nodiscard]] std::uint64_t requests() const { return requests_; }

 private:
  MemoryPort& memory_;
  std::vector<Cycle> free_;  ///< when each slot is, counted modulo their number
  std::size_t next_ = 0, held_ = 0;
  std::uint32_t tags_, next_tag_ = 0;  ///< slots' numbers, counted modulo a multiple of four
  Cycle request_free_ = 0;
  std::uint64_t requests_ = 0;
};

}  // namespace ptm::pipeline
