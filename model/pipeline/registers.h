#pragma once
#include <algorithm>
#include <array>
#include <cstddef>

#include "model/pipeline/stream_timing.h"

/// Time of the unit's storage elements as maxima over earlier cycles: no clock is stepped. All
/// items pass in order, and an item's cycles follow from those of the items before it.
namespace ptm::pipeline {

/// N pipeline registers in a row (rtl/stream/ptm_stream_chain.sv). A register accepts when it is
/// empty or being emptied (docs/spec/unit-timing.md, T6), so with enter_i(n) the cycle of item n's
/// transfer into register i:
///
///     enter_i(n) = max(enter_(i-1)(n) + 1, enter_(i+1)(n-1))
///
/// Put into itself N times, with leave(n) the transfer out of the last register, this is
///
///     enter_0(n) = max(offered(n), enter_0(n-1) + 1, leave(n-N))
///     enter_(N-1)(n) + 1 = max(enter_0(n) + N, leave(n-1) + 1)
///
/// (the terms in between are bounded by these: enter_1(n-2) + 1 <= enter_0(n-1) + 1, and so on).
template <std::size_t N>
class RegisterChain {
 public:
  /// `leave(cycle)` is told from which cycle on the item stands in the last register, and says in
  /// which one it is taken from there. Returns the cycle in which the first register takes it.
  template <class Leave>
  Cycle accept(Cycle offered, Leave&& leave) {
    Cycle& left_before = left_[next_];
    const Cycle enter = std::max(offered, free());
    const Cycle left = leave(std::max(enter + N, leave_next_));
    enter_next_ = enter + 1;
    leave_next_ = left + 1;
    left_before = left;
    next_ = next_ + 1 == N ? 0 : next_ + 1;
    return enter;
  }

  /// From when on the first register accepts: enter_1 of the item before, which is the enter_0 of
  /// an item that is offered early.
  [[nodiscard]] Cycle free() const { return std::max(enter_next_, left_[next_]); }

 private:
  std::array<Cycle, N> left_{};  ///< when the last N items left the chain, a ring
  std::size_t next_ = 0;
  Cycle enter_next_ = 0, leave_next_ = 0;  ///< the earliest for the next item
};

/// A FIFO of registers (rtl/stream/ptm_stream_fifo2.sv): latency 1; full at the start of a cycle,
/// it accepts nothing (T6), so a slot is usable the cycle after it was emptied.
template <std::size_t Depth>
class TimedFifo {
 public:
  /// `pop(cycle)` is told from which cycle on the item stands at the output, and says in which one
  /// it is taken. Returns the cycle of the push.
  template <class Pop>
  Cycle accept(Cycle offered, Pop&& pop) {
    Cycle& slot_usable = usable_[next_];
    const Cycle push = std::max(offered, slot_usable);
    const Cycle popped = pop(std::max(push + 1, output_free_));
    slot_usable = output_free_ = popped + 1;
    next_ = next_ + 1 == Depth ? 0 : next_ + 1;
    return push;
  }

 private:
  std::array<Cycle, Depth> usable_{};
  std::size_t next_ = 0;
  Cycle output_free_ = 0;
};

}  // namespace ptm::pipeline
