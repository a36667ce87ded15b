// The evaluator's time, computed by maxima, against the same rules stepped cycle by cycle.
#include "model/pipeline/registers.h"

#include <gtest/gtest.h>

#include "model/pipeline/simulate.h"
#include "tests/pipeline/stepped_registers.h"

namespace ptm::pipeline {
namespace {

using reference::LrgbOperands;
using reference::RgbOperands;

constexpr std::array<StreamTiming, 6> kTimings{
    {{1, 0, 0}, {2, 0.5, 0}, {3, 0, 0.5}, {4, 0.3, 0.3}, {5, 0.05, 0.9}, {6, 0.9, 0.05}}};

class EvaluatorTiming : public testing::TestWithParam<StreamTiming> {};

TEST_P(EvaluatorTiming, OfLrgbBeatsEqualsTheSteppedRulesInEveryCycle) {
  const std::vector<LrgbOperands<>> operands(5000);
  const auto frame = simulate_evaluator(reference::kBase, operands, GetParam());
  tests::SteppedChain stepped(7);
  stepped.run(operands.size(), 1, GetParam());
  EXPECT_EQ(frame.cycles, stepped.taken);
  EXPECT_EQ(frame.first_operand, stepped.accepted.front());
}

TEST_P(EvaluatorTiming, OfRgbPassesEqualsTheSteppedRulesInEveryCycle) {
  const std::vector<RgbOperands<>> operands(3000);
  const auto frame = simulate_evaluator(reference::kBase, operands, GetParam());
  tests::SteppedChain stepped(7);
  stepped.run(operands.size(), 3, GetParam());
  EXPECT_EQ(frame.cycles, stepped.taken);
}

INSTANTIATE_TEST_SUITE_P(GapsAndStalls, EvaluatorTiming, testing::ValuesIn(kTimings));

TEST(Evaluator, GivesItsFirstPixelEightCyclesAfterTheOperandAndThenOneACycle) {
  const std::vector<LrgbOperands<>> operands(100);
  const auto frame = simulate_evaluator(reference::kBase, operands, {});
  for (std::size_t n = 0; n < operands.size(); ++n) EXPECT_EQ(frame.cycles[n], 8 + n);
  EXPECT_EQ(frame.evaluator_cycles, 108U);
  EXPECT_EQ(frame.multiplies, 1100U);
  EXPECT_EQ(frame.input_stalled + frame.output_blocked, 0U);
}

TEST(Evaluator, HoldsNineBeatsBehindABlockedOutput) {
  RegisterChain<7> registers;
  TimedFifo<2> fifo;
  constexpr Cycle kBlockedUntil = 1000;
  Cycle next = 0;
  std::vector<Cycle> accepted;
  for (int n = 0; n < 12; ++n) {
    accepted.push_back(registers.accept(next, [&](Cycle last) {
      return fifo.accept(last, [&](Cycle out) { return std::max(out, kBlockedUntil); });
    }));
    next = accepted.back() + 1;
  }
  EXPECT_LT(accepted[8], kBlockedUntil);
  EXPECT_EQ(accepted[9], kBlockedUntil + 1) << "a slot is usable the cycle after it was emptied";
}

}  // namespace
}  // namespace ptm::pipeline
