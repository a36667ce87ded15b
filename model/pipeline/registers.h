#pragma once
#include <algorithm>
#include <array>
#include <cstddef>

#include "model/pipeline/stream_timing.h"

/// Time of the unit's storage elements as maxima over earlier cycles: no clock is stepped. All
/// items pass in order, and an item's cycles follow from those of the items before it.
namespace ptm::pipeline {

/// N pipeline registers in a row (rtl/ptm_stream_chain.sv). A register accepts when it is empty or
/// being emptied (docs/spec/pipeline.md, T6), so with enter_i(n) the cycle of item n's transfer
/// into register i:
///
///     enter_i(n) = max(enter_(i-1)(n) + 1, enter_(i+1)(n-1))
template <std::size_t N>
class RegisterChain {
 public:
  /// `leave(cycle)` is told from which cycle on the item stands in the last register, and says in
  /// which one it is taken from there. Returns the cycle in which the first register takes it.
  template <class Leave>
  Cycle accept(Cycle offered, Leave&& leave) {
    std::array<Cycle, N> enter;
    enter[0] = std::max(offered, departed_[0]);
    for (std::size_t i = 1; i < N; ++i) enter[i] = std::max(enter[i - 1] + 1, departed_[i]);
    for (std::size_t i = 0; i + 1 < N; ++i) departed_[i] = enter[i + 1];
    departed_[N - 1] = leave(enter[N - 1] + 1);
    return enter[0];
  }

 private:
  std::array<Cycle, N> departed_{};  ///< when the previous item left each register
};

/// A FIFO of registers (rtl/ptm_stream_fifo2.sv): latency 1; full at the start of a cycle, it
/// accepts nothing (T6), so a slot is usable the cycle after it was emptied.
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
    next_ = (next_ + 1) % Depth;
    return push;
  }

 private:
  std::array<Cycle, Depth> usable_{};
  std::size_t next_ = 0;
  Cycle output_free_ = 0;
};

}  // namespace ptm::pipeline
