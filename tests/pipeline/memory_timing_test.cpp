#include "model/pipeline/memory_timing.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <vector>

namespace ptm::pipeline {
namespace {

struct Request {
  std::uint32_t address;
  Cycle cycle;
};

std::vector<Cycle> answers(MemoryTiming& memory, const std::vector<Request>& requests) {
  std::vector<Cycle> done;
  for (std::size_t n = 0; n < requests.size(); ++n) {
    done.push_back(memory.line(n, requests[n].address, requests[n].cycle));
  }
  return done;
}

/// Requests at hashed addresses, some back to back, some after a pause.
std::vector<Request> stress(std::size_t count) {
  std::vector<Request> requests;
  Cycle cycle = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const std::uint64_t h = hash(7, n);
    cycle += 1 + (h % 8 == 0 ? h / 8 % 50 : 0);
    requests.push_back({static_cast<std::uint32_t>(h >> 40) % 4096, cycle});
  }
  return requests;
}

TEST(FixedMemory, AnswersAfterItsLatencyAndThenOnceAnInterval) {
  const auto memory = make_memory(FixedMemory{100, 4});
  EXPECT_EQ(answers(*memory, {{0, 0}, {1, 1}, {2, 2}, {3, 50}, {4, 300}}),
            (std::vector<Cycle>{100, 104, 108, 150, 400}));
}

TEST(DramMemory, ReadsAClosedRowThenAnOpenOneThenAnother) {
  const DramMemory timing{.banks = 2,
                          .page_lines = 4,
                          .tRCD = 14,
                          .tRP = 13,
                          .CL = 12,
                          .tRAS = 33,
                          .burst = 4,
                          .tREFI = 0,
                          .tRFC = 0,
                          .overhead = 10};
  const auto memory = make_memory(timing);
  // Closed row: read at 0 + tRCD, data from 26 to 30, answer 40. The row is open then: line 1 is
  // read 4 cycles after line 0, the bus follows. Line 8 is row 1 of the same bank: precharge at
  // tRAS = 33, activate at 46, read at 60, data at 72 .. 76. Line 4 is the other bank's: activated
  // at 3 and ready at 17, but its data wait for the bus in request order.
  EXPECT_EQ(answers(*memory, {{0, 0}, {1, 1}, {8, 2}, {4, 3}}),
            (std::vector<Cycle>{40, 44, 86, 90}));
  // Line 9, long after: its row is open.
  EXPECT_EQ(memory->line(4, 9, 1000), 1000U + 12 + 4 + 10);
  memory->reset();
  EXPECT_EQ(memory->line(0, 0, 0), 40U);
}

TEST(DramMemory, ClosesEveryRowAtARefreshAndWaitsForItsEnd) {
  const DramMemory timing{.banks = 4,
                          .page_lines = 32,
                          .tRCD = 14,
                          .tRP = 14,
                          .CL = 14,
                          .tRAS = 33,
                          .burst = 4,
                          .tREFI = 1000,
                          .tRFC = 100,
                          .overhead = 0};
  const auto memory = make_memory(timing);
  // 0: closed. 999: open, begun before the refresh. 1000: waits to 1100, then a closed row.
  // 1500: open again. 2300: closed by the refresh at 2000, though that has ended.
  EXPECT_EQ(answers(*memory, {{0, 0}, {1, 999}, {2, 1000}, {3, 1500}, {4, 2300}}),
            (std::vector<Cycle>{32, 1017, 1132, 1518, 2332}));
}

/// The cycle after the last of a stream of lines, all asked for at once.
Cycle stream_end(const DramMemory& timing, std::uint32_t lines) {
  const auto memory = make_memory(timing);
  Cycle last = 0;
  for (std::uint32_t n = 0; n < lines; ++n) last = memory->line(n, n, n);
  return last;
}

TEST(DramMemory, MovesNoDataForReadsThatARefreshForbids) {
  // Of each tREFI cycles, reads are given in tREFI - tRFC at most, so their data take the bus for
  // that long, and for what the last read before the refresh still brings.
  for (const Cycle tRFC : {Cycle{0}, Cycle{100}, Cycle{200}, Cycle{350}}) {
    const DramMemory timing{.tREFI = 400, .tRFC = tRFC, .overhead = 0};
    const Cycle busy = 4096 * timing.burst;
    const Cycle a_period = timing.tREFI - tRFC + timing.burst;
    EXPECT_GE(stream_end(timing, 4096), busy / a_period * timing.tREFI) << "tRFC " << tRFC;
  }
  const DramMemory usual{.overhead = 0};
  const Cycle busy = 65536 * usual.burst;
  EXPECT_GE(stream_end(usual, 65536),
            busy / (usual.tREFI - usual.tRFC + usual.burst) * usual.tREFI);
}

TEST(DramMemory, FillsTheBusWithoutRefreshAndAfterAFirstRow) {
  const DramMemory timing{.tREFI = 0, .overhead = 0};
  EXPECT_EQ(stream_end(timing, 32), timing.tRCD + timing.CL + 32 * timing.burst);
}

TEST(DramMemory, OpensARowAgainThatWaitedForTheBusUntilARefresh) {
  const DramMemory timing{.banks = 2,
                          .page_lines = 1,
                          .tRCD = 10,
                          .tRP = 10,
                          .CL = 10,
                          .tRAS = 30,
                          .burst = 50,
                          .tREFI = 100,
                          .tRFC = 40,
                          .overhead = 0};
  const auto memory = make_memory(timing);
  // Line 0: activate 0, read 10, data 20 .. 70. Line 1, other bank: activate 1, read 60 when its
  // data find the bus free, data 70 .. 120. Line 2, other row of the first bank: precharge 60,
  // activate 70, could be read at 80, but the bus is taken until 120, so the read would be given
  // at 110, in the refresh. It opens again at 140: read 150, data 160 .. 210.
  EXPECT_EQ(answers(*memory, {{0, 0}, {1, 1}, {2, 2}}), (std::vector<Cycle>{70, 120, 210}));
}

TEST(RandomMemory, AnswersOutOfOrderWithinItsRange) {
  const auto memory = make_memory(RandomMemory{3, 5, 80});
  bool overtakes = false;
  Cycle last = 0;
  for (std::uint64_t n = 0; n < 1000; ++n) {
    const Cycle done = memory->line(n, 0, n * 100);
    EXPECT_GE(done, n * 100 + 5);
    EXPECT_LE(done, n * 100 + 80);
  }
  memory->reset();
  for (std::uint64_t n = 0; n < 100; ++n) {
    const Cycle done = memory->line(n, 0, n);
    overtakes = overtakes || done < last;
    last = done;
  }
  EXPECT_TRUE(overtakes);
}

TEST(RandomMemory, TakesTheNextFreeCycleWhereOneIsTaken) {
  const auto memory = make_memory(RandomMemory{1, 10, 10});
  EXPECT_EQ(memory->line(0, 0, 5), 15U);
  EXPECT_EQ(memory->line(1, 0, 5), 16U);
  EXPECT_EQ(memory->line(2, 0, 6), 17U);
  EXPECT_EQ(memory->line(3, 0, 9), 19U);
}

class AnyMemory : public testing::TestWithParam<MemoryModel> {};

TEST_P(AnyMemory, AnswersLaterThanAskedAndNeverTwiceInACycle) {
  const auto requests = stress(20000);
  const auto memory = make_memory(GetParam());
  const auto done = answers(*memory, requests);
  std::set<Cycle> seen;
  for (std::size_t n = 0; n < done.size(); ++n) {
    ASSERT_GT(done[n], requests[n].cycle) << "request " << n;
    ASSERT_TRUE(seen.insert(done[n]).second) << "request " << n << ", cycle " << done[n];
  }
}

TEST_P(AnyMemory, AnswersTheFirstRequestsAlikeWhateverComesLater) {
  const auto requests = stress(2000);
  auto other = requests;
  for (std::size_t n = 1000; n < other.size(); ++n) {
    other[n].address ^= 1234;
    other[n].cycle += 17;
  }
  auto one = answers(*make_memory(GetParam()), requests);
  auto two = answers(*make_memory(GetParam()), other);
  EXPECT_NE(one, two);
  one.resize(1000);
  two.resize(1000);
  EXPECT_EQ(one, two);
}

TEST_P(AnyMemory, StartsAnewAfterAReset) {
  const auto memory = make_memory(GetParam());
  const auto requests = stress(500);
  const auto once = answers(*memory, requests);
  memory->reset();
  EXPECT_EQ(answers(*memory, requests), once);
}

INSTANTIATE_TEST_SUITE_P(Kinds, AnyMemory,
                         testing::Values(MemoryModel(FixedMemory{}), MemoryModel(FixedMemory{1, 1}),
                                         MemoryModel(DramMemory{}), MemoryModel(RandomMemory{}),
                                         MemoryModel(RandomMemory{9, 1, 5000})));

TEST(Memory, RefusesTimingsUnderWhichAnswersWouldMeet) {
  EXPECT_THROW((void)make_memory(FixedMemory{0, 4}), std::invalid_argument);
  EXPECT_THROW((void)make_memory(FixedMemory{10, 0}), std::invalid_argument);
  EXPECT_THROW((void)make_memory(DramMemory{.burst = 0}), std::invalid_argument);
  EXPECT_THROW((void)make_memory(DramMemory{.tREFI = 100, .tRFC = 100}), std::invalid_argument);
  EXPECT_THROW((void)make_memory(RandomMemory{1, 0, 10}), std::invalid_argument);
  EXPECT_THROW((void)make_memory(RandomMemory{1, 10, 9}), std::invalid_argument);
}

}  // namespace
}  // namespace ptm::pipeline
