#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/pipeline/memory_timing.h"

namespace ptm::pipeline {
namespace {

enum class Kind : std::uint8_t { precharge, activate, read };

struct Command {
  Kind kind;
  int bank;
  std::int64_t row;
  Cycle cycle;
};

/// A data sheet's rules, asked of one command at a time: what was given before, and no state but
/// that. A second way to the times of DramMemory, which computes them.
class DataSheet {
 public:
  explicit DataSheet(const DramMemory& timing) : timing_(timing) {}

  /// The cycle in which the answer to a request arrives: each command in the first legal cycle,
  /// found by trying one cycle after another, and all between the same refreshes.
  Cycle line(std::uint32_t address, Cycle asked) {
    const int page = static_cast<int>(address) / timing_.page_lines;
    const int bank = page % timing_.banks;
    const std::int64_t row = page / timing_.banks;
    for (Cycle from = asked;; from = (period(from) + 1) * timing_.tREFI) {
      const std::size_t given = log_.size();
      const Cycle end = timing_.tREFI == 0 ? kNever : (period(from) + 1) * timing_.tREFI;
      if (!is_open(bank, row, from)) {
        if (is_open(bank, kAny, from) && !give({Kind::precharge, bank, kAny, from}, end)) continue;
        if (!give({Kind::activate, bank, row, from}, end)) {
          log_.resize(given);
          continue;
        }
      }
      if (give({Kind::read, bank, row, from}, end)) break;
      log_.resize(given);
    }
    return log_.back().cycle + timing_.CL + timing_.burst + timing_.overhead;
  }

  [[nodiscard]] bool is_legal(const Command& c) const {
    if (in_refresh(c.cycle)) return false;
    const Command* activate = last(Kind::activate, c.bank);
    const Command* precharge = last(Kind::precharge, c.bank);
    const Command* read = last(Kind::read, c.bank);
    // The bank is busy with a burst; no command overtakes another of its bank.
    if (read && c.cycle < read->cycle + timing_.burst) return false;
    for (const Command* before : {activate, precharge}) {
      if (before && c.cycle < before->cycle) return false;
    }
    switch (c.kind) {
      case Kind::precharge:
        return activate && c.cycle >= activate->cycle + timing_.tRAS;
      case Kind::activate:
        return !is_open(c.bank, kAny, c.cycle) &&
               (!precharge || c.cycle >= precharge->cycle + timing_.tRP) &&
               (!activate || c.cycle >= activate->cycle + timing_.tRAS + timing_.tRP);
      case Kind::read:
        break;
    }
    if (!is_open(c.bank, c.row, c.cycle) || c.cycle < activate->cycle + timing_.tRCD) return false;
    // Data on the bus in request order, none over another's.
    return std::none_of(log_.begin(), log_.end(), [&](const Command& other) {
      return other.kind == Kind::read && c.cycle < other.cycle + timing_.burst;
    });
  }

 private:
  static constexpr std::int64_t kAny = -1;

  [[nodiscard]] Cycle period(Cycle cycle) const {
    return timing_.tREFI == 0 ? 0 : cycle / timing_.tREFI;
  }
  [[nodiscard]] bool in_refresh(Cycle cycle) const {
    return period(cycle) > 0 && cycle % timing_.tREFI < timing_.tRFC;
  }

  [[nodiscard]] const Command* last(Kind kind, int bank) const {
    const auto found = std::find_if(log_.rbegin(), log_.rend(), [&](const Command& c) {
      return c.kind == kind && c.bank == bank;
    });
    return found == log_.rend() ? nullptr : &*found;
  }

  /// Activated, and since then neither precharged nor refreshed.
  [[nodiscard]] bool is_open(int bank, std::int64_t row, Cycle cycle) const {
    for (std::size_t n = log_.size(); n-- > 0;) {
      const Command& c = log_[n];
      if (c.bank != bank || c.kind == Kind::read) continue;
      return c.kind == Kind::activate && (row == kAny || c.row == row) &&
             period(c.cycle) == period(cycle);
    }
    return false;
  }

  /// Gives the command in the first legal cycle before `end`, if there is one.
  bool give(Command command, Cycle end) {
    for (; command.cycle < end; ++command.cycle) {
      if (!is_legal(command)) continue;
      log_.push_back(command);
      return true;
    }
    return false;
  }

  DramMemory timing_;
  std::vector<Command> log_;
};

std::string shown(const DramMemory& t) {
  std::string text;
  for (const Cycle value : {static_cast<Cycle>(t.banks), static_cast<Cycle>(t.page_lines), t.tRCD,
                            t.tRP, t.CL, t.tRAS, t.burst, t.tREFI, t.tRFC, t.overhead}) {
    text += std::to_string(value) + " ";
  }
  return text;
}

TEST(DramTiming, AnswersInTheFirstCycleThatTheDataSheetAllows) {
  // Small numbers, 0 included, so that every rule is the deciding one somewhere.
  std::uint64_t n = 0;
  const auto draw = [&](std::uint64_t below) { return hash(11, n++) % below; };
  for (int round = 0; round < 400; ++round) {
    DramMemory timing{.banks = 1 << draw(3), .page_lines = 1 << draw(3)};
    timing.tRCD = draw(12);
    timing.tRP = draw(12);
    timing.CL = draw(12);
    timing.tRAS = draw(40);
    timing.burst = 1 + draw(6);
    timing.tRFC = draw(60);
    timing.tREFI = draw(4) == 0 ? 0 : timing.tRFC + timing.tRCD + 1 + draw(150);
    timing.overhead = draw(5);
    const auto memory = make_memory(timing);
    DataSheet sheet(timing);
    const std::uint64_t pause = 1 + draw(60);
    Cycle cycle = draw(100);
    for (std::uint64_t k = 0; k < 60; ++k) {
      const auto address = static_cast<std::uint32_t>(draw(24));
      const Cycle done = memory->line(k, address, cycle);
      ASSERT_EQ(done, sheet.line(address, cycle))
          << "request " << k << " of line " << address << " in " << cycle << ", " << shown(timing);
      cycle += 1 + draw(pause);
    }
  }
}

/// One parameter of primes, none a sum of others, so that a wrong one cannot pass for another.
constexpr DramMemory kPrimes{.banks = 2,
                             .page_lines = 4,
                             .tRCD = 13,
                             .tRP = 17,
                             .CL = 11,
                             .tRAS = 37,
                             .burst = 5,
                             .tREFI = 0,
                             .tRFC = 0,
                             .overhead = 0};
constexpr std::uint32_t kOtherBank = 4, kOtherRow = 8;
/// From a read to the end of its data.
constexpr Cycle kData = 11 + 5;

/// A bank that has opened row 0 in cycle 0 and read a line.
std::unique_ptr<MemoryTiming> opened(const DramMemory& timing) {
  auto memory = make_memory(timing);
  EXPECT_EQ(memory->line(0, 0, 0), timing.tRCD + timing.CL + timing.burst);
  return memory;
}

TEST(DramTiming, ReadsARowTRcdAfterItsActivation) {
  const auto memory = make_memory(kPrimes);
  EXPECT_EQ(memory->line(0, 0, 100), 100 + 13 + kData);
}

TEST(DramTiming, ReadsAnOpenRowAtOnce) {
  EXPECT_EQ(opened(kPrimes)->line(1, 3, 1000), 1000 + kData);
}

TEST(DramTiming, PrechargesNoEarlierThanTRasAfterTheActivation) {
  // The row was opened in 0: a request in 36 waits one cycle for tRAS, one in 37 and 38 does not.
  for (const Cycle asked : {Cycle{36}, Cycle{37}, Cycle{38}}) {
    const Cycle precharge = std::max<Cycle>(asked, 37);
    EXPECT_EQ(opened(kPrimes)->line(1, kOtherRow, asked), precharge + 17 + 13 + kData) << asked;
  }
}

TEST(DramTiming, ActivatesABankTRcApart) {
  // Every request of another row: activations tRAS + tRP apart, and no sooner.
  const auto memory = make_memory(kPrimes);
  for (std::uint32_t n = 0; n < 20; ++n) {
    EXPECT_EQ(memory->line(n, n * kOtherRow, n), n * (37 + 17) + 13 + kData) << n;
  }
}

TEST(DramTiming, ActivatesABankTRcApartAcrossARefreshToo) {
  DramMemory timing = kPrimes;
  timing.tREFI = 100;
  timing.tRFC = 10;
  // Opened in 80; the refresh of 100 closes it, which is over in 110; tRC ends in 80 + 54.
  const auto memory = make_memory(timing);
  EXPECT_EQ(memory->line(0, 0, 80), 80 + 13 + kData);
  EXPECT_EQ(memory->line(1, 1, 105), 80 + 37 + 17 + 13 + kData);
}

TEST(DramTiming, LetsABankWorkWhileAnotherReads) {
  // Activated in 1, ready in 14: its read waits for the bus alone, 5 cycles after the one of 13.
  EXPECT_EQ(opened(kPrimes)->line(1, kOtherBank, 1), 13 + 5 + kData);
  // Asked in 6, its row is ready in 19, when the bus is free.
  EXPECT_EQ(opened(kPrimes)->line(1, kOtherBank, 6), 6 + 13 + kData);
}

TEST(DramTiming, KeepsTheBusFullOfAnOpenRow) {
  DramMemory timing = kPrimes;
  timing.page_lines = 512;
  const auto memory = make_memory(timing);
  for (std::uint32_t n = 0; n < 512; ++n) {
    EXPECT_EQ(memory->line(n, n, n), 13 + 11 + (n + 1) * 5) << n;
  }
}

TEST(DramTiming, GivesNoCommandInARefresh) {
  DramMemory timing = kPrimes;
  timing.tREFI = 1000;
  timing.tRFC = 101;
  // An open row is read in the last cycle before the refresh, and not in the next.
  EXPECT_EQ(opened(timing)->line(1, 1, 999), 999 + kData);
  EXPECT_EQ(opened(timing)->line(1, 1, 1000), 1101 + 13 + kData);
  // In the last cycle of a refresh it waits for one cycle more, from the next on for none.
  EXPECT_EQ(opened(timing)->line(1, 1, 1100), 1101 + 13 + kData);
  EXPECT_EQ(opened(timing)->line(1, 1, 1101), 1101 + 13 + kData);
  EXPECT_EQ(opened(timing)->line(1, 1, 1102), 1102 + 13 + kData);
  // Activation and read both come before a refresh, the read in 999 at the latest, or both after.
  EXPECT_EQ(make_memory(timing)->line(0, 0, 999 - 13), 999 + kData);
  EXPECT_EQ(make_memory(timing)->line(0, 0, 1000 - 13), 1101 + 13 + kData);
  // Precharge, activation and read likewise.
  EXPECT_EQ(opened(timing)->line(1, kOtherRow, 999 - 13 - 17), 999 + kData);
  EXPECT_EQ(opened(timing)->line(1, kOtherRow, 1000 - 13 - 17), 1101 + 13 + kData);
  // Nothing is refreshed before the first tREFI is over.
  EXPECT_EQ(make_memory(timing)->line(0, 0, 50), 50 + 13 + kData);
}

TEST(DramTiming, AnswersItsOverheadAfterTheData) {
  DramMemory timing = kPrimes;
  timing.overhead = 23;
  const auto memory = make_memory(timing);
  EXPECT_EQ(memory->line(0, 0, 0), 13 + kData + 23);
  // It is on the way of the answer, not on the bus: the next line is 5 cycles later.
  EXPECT_EQ(memory->line(1, 1, 1), 13 + kData + 23 + 5);
}

TEST(DramTiming, BoundsAStreamByRefreshAndBus) {
  // Of a period's tREFI cycles, tREFI - tRFC give reads, whose data end CL + burst later at most:
  // data take the bus in tREFI - tRFC + CL + burst cycles of each period at most. From below: the
  // stream loses to each refresh its time and tRCD; a refresh more is begun for what remains.
  for (const auto& [tREFI, tRFC] : {std::array<Cycle, 2>{400, 200}, {7800, 260}}) {
    const DramMemory timing{.tRCD = 14,
                            .tRP = 14,
                            .CL = 14,
                            .tRAS = 34,
                            .burst = 4,
                            .tREFI = tREFI,
                            .tRFC = tRFC,
                            .overhead = 0};
    const Cycle busy = 4096 * timing.burst;
    const Cycle a_period = tREFI - tRFC + timing.CL + timing.burst;
    const auto memory = make_memory(timing);
    Cycle end = 0;
    for (std::uint32_t n = 0; n < 4096; ++n) end = memory->line(n, n, n);
    EXPECT_GE(end * a_period, busy * tREFI);                          // end >= 30,062 and 16,909
    const Cycle reads = (tREFI - tRFC - timing.tRCD) / timing.burst;  // of a period
    const Cycle periods = 4096 / reads + 1;
    EXPECT_LE(end, periods * tREFI + timing.tRFC + timing.tRCD + timing.CL + timing.burst);
  }
}

TEST(DramTiming, RefusesARefreshThatLeavesNoTimeForARead) {
  EXPECT_THROW((void)make_memory(DramMemory{.tRCD = 14, .tREFI = 114, .tRFC = 100}),
               std::invalid_argument);
  const auto memory = make_memory(
      DramMemory{.tRCD = 14, .CL = 1, .burst = 1, .tREFI = 115, .tRFC = 100, .overhead = 0});
  // Asked in a refresh: activated in 215, read in 229, the last cycle before the next one.
  EXPECT_EQ(memory->line(0, 0, 116), 231U);
}

}  // namespace
}  // namespace ptm::pipeline
