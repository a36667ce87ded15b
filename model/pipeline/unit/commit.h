#pragma once
#include "model/pipeline/unit/fetch.h"

namespace ptm::pipeline {

/// K: a beat's lines enter the caches, one rank a cycle, in order (T5).
class Commit final : public sc_core::sc_module {
 public:
  Commit(const sc_core::sc_module_name& name, Fetch& out) : sc_module(name), out_(out) {}

  struct Stay {
    Cycle enter = 0, leave = 0;
    bool was_empty = false;  ///< K held nothing in the cycle of the transfer
  };

  /// `offered`: from when on the beat stands at the FIFO's exit.
  template <bool kEffects>
  Stay accept(const UnitBeat& beat, Cycle offered) {
    Stay stay;
    stay.enter = std::max(offered, left_);
    stay.was_empty = first_ || stay.enter > left_;
    const Cycle stands = stay.enter + 1;
    const Cycle ready = std::max(stands, out_.free());
    stay.leave = ready;
    for (unsigned rank = 0; rank < beat.ranks; ++rank) {
      stay.leave = std::max(stay.leave + (rank != 0), beat.usable[rank]);
    }
    output_blocked_ += ready - stands;
    line_wait_ += stay.leave - ready;
    ++beats_;
    left_ = stay.leave;
    first_ = false;
    out_.accept<kEffects>(beat, stay.leave);
    return stay;
  }

  void reset() {
    left_ = 0;
    first_ = true;
    beats_ = output_blocked_ = line_wait_ = 0;
  }
  [[nodiscard]] std::uint64_t beats() const { return beats_; }
  [[nodiscard]] std::uint64_t output_blocked() const { return output_blocked_; }
  [[nodiscard]] std::uint64_t line_wait() const { return line_wait_; }

 private:
  Fetch& out_;
  Cycle left_ = 0;
  bool first_ = true;
  std::uint64_t beats_ = 0, output_blocked_ = 0, line_wait_ = 0;
};

}  // namespace ptm::pipeline
