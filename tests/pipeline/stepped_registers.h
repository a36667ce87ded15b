#pragma once
#include <deque>
#include <optional>
#include <vector>

#include "model/pipeline/stream_timing.h"

namespace ptm::tests {

/// The unit's storage, stepped cycle by cycle from the rules T6 alone: what the maxima of
/// model/pipeline/registers.h must agree with.
///
/// A pixel's beats pass `registers` pipeline registers; the last beat of a pixel goes through a
/// FIFO of two, the others vanish from the last register in the cycle after they arrived there.
struct SteppedChain {
  struct Beat {
    std::uint64_t item = 0;
    bool completes = true;
  };

  std::vector<std::optional<Beat>> registers;
  std::deque<Beat> fifo;
  std::vector<pipeline::Cycle> accepted, taken;

  explicit SteppedChain(std::size_t count) : registers(count) {}

  void run(std::uint64_t items, std::uint64_t beats_each, const pipeline::StreamTiming& timing) {
    std::uint64_t next = 0;
    const std::uint64_t beats = items * beats_each;
    pipeline::Cycle offered_from = gap(timing, 0);
    for (pipeline::Cycle cycle = 0; taken.size() < items; ++cycle) {
      const bool pop = !fifo.empty() && !stalled(timing, cycle);
      const bool fifo_ready = fifo.size() < 2;  // judged at the start of the cycle
      // Which registers move, from the last one forward.
      std::vector<bool> leaves(registers.size());
      for (std::size_t i = registers.size(); i-- > 0;) {
        if (!registers[i]) continue;
        if (i + 1 == registers.size()) {
          leaves[i] = !registers[i]->completes || fifo_ready;
        } else {
          leaves[i] = !registers[i + 1] || leaves[i + 1];
        }
      }
      const bool offered = next < beats && cycle >= offered_from;
      const bool accepts = offered && (!registers[0] || leaves[0]);
      // The clock edge.
      if (pop) {
        fifo.pop_front();
        taken.push_back(cycle);
      }
      for (std::size_t i = registers.size(); i-- > 0;) {
        if (!leaves[i]) continue;
        if (i + 1 < registers.size()) {
          registers[i + 1] = registers[i];
        } else if (registers[i]->completes) {
          fifo.push_back(*registers[i]);
        }
        registers[i].reset();
      }
      if (accepts) {
        registers[0] = Beat{next / beats_each, next % beats_each + 1 == beats_each};
        accepted.push_back(cycle);
        ++next;
        offered_from = cycle + 1 + gap(timing, next);
      }
    }
  }
};

}  // namespace ptm::tests
