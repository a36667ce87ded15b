#include "model/pipeline/memory_timing.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <vector>

namespace ptm::pipeline {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

class FixedTiming final : public MemoryTiming {
 public:
  explicit FixedTiming(const FixedMemory& memory) : memory_(memory) {
    require(memory.latency >= 1, "memory: latency is 0, expected at least 1 cycle");
    require(memory.interval >= 1, "memory: interval is 0, expected at least 1 cycle");
  }

  Cycle line(std::uint64_t, std::uint32_t, Cycle cycle) override {
    const Cycle done = std::max(cycle + memory_.latency, earliest_);
    earliest_ = done + memory_.interval;
    return done;
  }
  void reset() override { earliest_ = 0; }

 private:
  FixedMemory memory_;
  Cycle earliest_ = 0;
};

class DramTiming final : public MemoryTiming {
 public:
  explicit DramTiming(const DramMemory& memory) : memory_(memory) {
    require(memory.banks >= 1, "DRAM: banks is below 1");
    require(memory.page_lines >= 1, "DRAM: page_lines is below 1");
    require(memory.burst >= 1, "DRAM: burst is 0, expected at least 1 cycle");
    require(memory.tREFI == 0 || memory.tREFI > memory.tRFC,
            "DRAM: tREFI is not longer than tRFC (0 for no refresh)");
    reset();
  }

  Cycle line(std::uint64_t, std::uint32_t address, Cycle cycle) override {
    const std::uint32_t page = address / static_cast<std::uint32_t>(memory_.page_lines);
    const auto banks = static_cast<std::uint32_t>(memory_.banks);
    Bank& bank = banks_[page % banks];
    const Cycle start = outside_refresh(std::max(cycle, bank.ready));
    const Cycle opened = open(bank, page / banks, start);
    Cycle read = std::max(opened, earliest_read());
    // The row that waited for the bus until the next refresh is closed by it and opened again.
    if (read > opened && period_of(read) != bank.period) {
      read = open(bank, page / banks, outside_refresh(read));
    }
    bank.ready = read + memory_.burst;
    const Cycle data = std::max(read + memory_.CL, bus_free_);
    bus_free_ = data + memory_.burst;
    return bus_free_ + memory_.overhead;
  }

  void reset() override {
    banks_.assign(static_cast<std::size_t>(memory_.banks), {});
    bus_free_ = 0;
  }

 private:
  struct Bank {
    std::int64_t row = -1;  ///< open row, -1 for none
    Cycle activated = 0;
    Cycle ready = 0;   ///< for the next command
    Cycle period = 0;  ///< between which refreshes the row was opened
  };

  /// A read command whose data would meet a busy bus is not given: data follow it after CL.
  [[nodiscard]] Cycle earliest_read() const {
    return bus_free_ > memory_.CL ? bus_free_ - memory_.CL : 0;
  }

  [[nodiscard]] Cycle period_of(Cycle cycle) const {
    return memory_.tREFI == 0 ? 0 : cycle / memory_.tREFI;
  }

  [[nodiscard]] Cycle outside_refresh(Cycle cycle) const {
    const Cycle begin = period_of(cycle) * memory_.tREFI;
    return begin == 0 ? cycle : std::max(cycle, begin + memory_.tRFC);
  }

  /// Opens the row if it is not; returns the cycle of the read command.
  Cycle open(Bank& bank, std::int64_t row, Cycle start) const {
    if (bank.period != period_of(start)) bank.row = -1;
    bank.period = period_of(start);
    if (bank.row == row) return start;
    const bool other_row = bank.row >= 0;
    bank.activated =
        other_row ? std::max(start, bank.activated + memory_.tRAS) + memory_.tRP : start;
    bank.row = row;
    return bank.activated + memory_.tRCD;
  }

  DramMemory memory_;
  std::vector<Bank> banks_;
  Cycle bus_free_ = 0;
};

class RandomTiming final : public MemoryTiming {
 public:
  explicit RandomTiming(const RandomMemory& memory) : memory_(memory) {
    require(memory.latency_min >= 1, "memory: latency_min is 0, expected at least 1 cycle");
    require(memory.latency_max >= memory.latency_min, "memory: latency_max is below latency_min");
  }

  Cycle line(std::uint64_t index, std::uint32_t, Cycle cycle) override {
    // Answers up to this request's cycle can meet no later one.
    answers_.erase(answers_.begin(), answers_.upper_bound(cycle));
    const Cycle span = memory_.latency_max - memory_.latency_min + 1;
    Cycle done = cycle + memory_.latency_min + hash(memory_.seed, index) % span;
    while (!answers_.insert(done).second) ++done;
    return done;
  }
  void reset() override { answers_.clear(); }

 private:
  RandomMemory memory_;
  std::set<Cycle> answers_;  ///< still to come
};

}  // namespace

std::unique_ptr<MemoryTiming> make_memory(const FixedMemory& memory) {
  return std::make_unique<FixedTiming>(memory);
}
std::unique_ptr<MemoryTiming> make_memory(const DramMemory& memory) {
  return std::make_unique<DramTiming>(memory);
}
std::unique_ptr<MemoryTiming> make_memory(const RandomMemory& memory) {
  return std::make_unique<RandomTiming>(memory);
}
std::unique_ptr<MemoryTiming> make_memory(const MemoryModel& memory) {
  return std::visit([](const auto& kind) { return make_memory(kind); }, memory);
}

}  // namespace ptm::pipeline
