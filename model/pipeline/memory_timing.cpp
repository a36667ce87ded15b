#include "model/pipeline/memory_timing.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <vector>

namespace ptm::pipeline {
namespace {

class FixedTiming final : public MemoryTiming {
 public:
  explicit FixedTiming(const FixedMemory& memory) : memory_(memory) {
    reference::validate_parameters(memory);
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
    reference::validate_parameters(memory);
    reset();
  }

  Cycle line(std::uint64_t, std::uint32_t address, Cycle cycle) override {
    const std::uint32_t page = address / static_cast<std::uint32_t>(memory_.page_lines);
    const auto banks = static_cast<std::uint32_t>(memory_.banks);
    Bank& bank = banks_[page % banks];
    Cycle start = outside_refresh(std::max(cycle, bank.ready));
    Commands commands = earliest(bank, page / banks, start);
    // Commands that would not all come before the next refresh come after it, or after the last one
    // before the bus is free.
    while (period_of(commands.read) != period_of(start)) {
      const Cycle next = std::max(period_of(start) + 1, period_of(earliest_read()));
      start = refreshed(next);
      commands = earliest(bank, page / banks, start);
    }
    bank.row = page / banks;
    bank.activated = commands.activate;
    bank.next_activate = commands.activate + memory_.tRAS + memory_.tRP;
    bank.period = period_of(start);
    bank.ready = commands.read + memory_.burst;
    const Cycle data = commands.read + memory_.CL;
    bus_free_ = data + memory_.burst;
    return bus_free_ + memory_.overhead;
  }

  void reset() override {
    banks_.assign(static_cast<std::size_t>(memory_.banks), {});
    bus_free_ = 0;
  }

 private:
  struct Bank {
    std::int64_t row = -1;  ///< last opened row, -1 for none
    Cycle activated = 0;
    Cycle next_activate = 0;  ///< tRC after that
    Cycle ready = 0;          ///< for the next command
    Cycle period = 0;         ///< between which refreshes the row was opened
  };
  struct Commands {
    Cycle activate = 0;  ///< of the row that is read, now or earlier
    Cycle read = 0;
  };

  /// A read command whose data would meet a busy bus is not given: data follow it after CL.
  [[nodiscard]] Cycle earliest_read() const {
    return bus_free_ > memory_.CL ? bus_free_ - memory_.CL : 0;
  }

  [[nodiscard]] Cycle period_of(Cycle cycle) const {
    return memory_.tREFI == 0 ? 0 : cycle / memory_.tREFI;
  }

  /// The first cycle of a period in which commands may come.
  [[nodiscard]] Cycle refreshed(Cycle period) const {
    return period == 0 ? 0 : period * memory_.tREFI + memory_.tRFC;
  }

  [[nodiscard]] Cycle outside_refresh(Cycle cycle) const {
    return std::max(cycle, refreshed(period_of(cycle)));
  }

  /// The commands that read a row, none before `start`, as if no refresh came after it.
  [[nodiscard]] Commands earliest(const Bank& bank, std::int64_t row, Cycle start) const {
    const bool open = bank.row >= 0 && bank.period == period_of(start);
    if (open && bank.row == row) return {bank.activated, std::max(start, earliest_read())};
    // A precharge that waits for tRAS is one that waits for tRC.
    const Cycle activate = std::max(open ? start + memory_.tRP : start, bank.next_activate);
    return {activate, std::max(activate + memory_.tRCD, earliest_read())};
  }

  DramMemory memory_;
  std::vector<Bank> banks_;
  Cycle bus_free_ = 0;
};

class RandomTiming final : public MemoryTiming {
 public:
  explicit RandomTiming(const RandomMemory& memory) : memory_(memory) {
    reference::validate_parameters(memory);
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
