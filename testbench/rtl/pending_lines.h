#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/pipeline/stream_timing.h"

namespace ptm::testbench {

/// Requests that the memory has accepted and not answered, by the cycle of their answer.
class PendingLines {
 public:
  struct Answer {
    pipeline::Cycle cycle = 0;
    std::uint64_t index = 0;  ///< of the request in its frame
    std::uint32_t line = 0;
    std::uint8_t tag = 0;
    friend bool operator>(const Answer& a, const Answer& b) { return a.cycle > b.cycle; }
  };

  void clear() {
    heap_.clear();
    next_ = pipeline::Cycle(~0ULL);
  }
  void add(const Answer& answer) {
    heap_.push_back(answer);
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
    next_ = heap_.front().cycle;
  }
  [[nodiscard]] bool due(pipeline::Cycle cycle) const { return next_ == cycle; }
  Answer take() {
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    const Answer answer = heap_.back();
    heap_.pop_back();
    next_ = heap_.empty() ? pipeline::Cycle(~0ULL) : heap_.front().cycle;
    return answer;
  }
  [[nodiscard]] bool outstanding(std::uint8_t tag) const {
    return std::any_of(heap_.begin(), heap_.end(), [&](const Answer& a) { return a.tag == tag; });
  }

 private:
  std::vector<Answer> heap_;
  pipeline::Cycle next_ = pipeline::Cycle(~0ULL);
};

}  // namespace ptm::testbench
