// What the word fetch holds while the evaluator refuses: its values and free rate do not tell.
#include "model/pipeline/word_fetch.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "model/pipeline/ideal_memory.h"

namespace ptm::pipeline {
namespace {

/// Refuses everything until a cycle, then takes one beat a cycle.
class BlockedEvaluator : public sc_core::sc_module, public StreamTarget<EvaluatorBeat> {
 public:
  sc_core::sc_export<StreamTarget<EvaluatorBeat>> in{"in"};
  BlockedEvaluator(const sc_core::sc_module_name& name, Cycle until)
      : sc_module(name), free_(until) {
    in.bind(*this);
  }
  Cycle accept(const EvaluatorBeat&, Cycle offered) override {
    const Cycle taken = std::max(offered, free_);
    free_ = taken + 1;
    return taken;
  }

 private:
  Cycle free_;
};

constexpr Cycle kBlockedUntil = 1000;

/// The cycles in which eight fragments, offered as soon as may be, are taken.
std::vector<Cycle> accepted(int tmus, bool rgb, int coef_bits = 8) {
  const reference::StoredTexture map{.width = 4, .height = 4, .rgb = rgb};
  const TextureDescriptor texture{reference::layout_of({.coef_bits = coef_bits}, map), {}, {}};
  const std::vector<std::uint32_t> words(texture.layout.words());
  const sc_core::sc_time clock(1, sc_core::SC_NS);
  IdealMemory memory("memory", words, clock);
  WordFetch fetch("fetch", tmus, texture, clock);
  BlockedEvaluator evaluator("evaluator", kBlockedUntil);
  fetch.out(evaluator.in);
  for (auto& socket : fetch.tmu) socket.bind(memory.socket);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  std::vector<Cycle> cycles;
  Cycle next = 0;
  for (int n = 0; n < 8; ++n) {
    cycles.push_back(fetch.accept({}, next));
    next = cycles.back() + 1;
  }
  return cycles;
}

TEST(WordFetch, HoldsAFragmentInEachOfItsFourRegisters) {
  // address, request, words, operands; the fifth is taken when all move on.
  EXPECT_EQ(accepted(3, false), (std::vector<Cycle>{0, 1, 2, 3, 1000, 1001, 1002, 1003}));
}

TEST(WordFetch, HoldsThreeFragmentsWhenATexelIsThreeBeats) {
  // One in operands, one gathered but for its last word, one in address with its first beat out.
  // That one's second and third beats leave in cycles 1000 and 1001.
  const auto cycles = accepted(1, false);
  EXPECT_EQ(std::vector<Cycle>(cycles.begin(), cycles.begin() + 4),
            (std::vector<Cycle>{0, 3, 6, 1001}));
  EXPECT_EQ(cycles[7] - cycles[6], 3U);
}

TEST(WordFetch, KeepsAnRgbTexelUntilItsThirdPassIsTaken) {
  const auto cycles = accepted(3, true);
  EXPECT_LT(cycles[2], kBlockedUntil);
  EXPECT_GT(cycles[3], kBlockedUntil + 1) << "two passes of the first texel are still to go";
  EXPECT_EQ(cycles[7] - cycles[6], 3U);
}

TEST(WordFetch, TakesTwoBeatsATexelOfFourWordsWhereAWordHoldsTwoCoefficients) {
  // One in operands, one gathered but for its last word, one in address with its first beat out:
  // that one's second beat leaves in cycle 1000.
  const auto cycles = accepted(3, false, 12);
  EXPECT_EQ(std::vector<Cycle>(cycles.begin(), cycles.begin() + 4),
            (std::vector<Cycle>{0, 2, 4, 1000}));
  EXPECT_EQ(cycles[7] - cycles[6], 2U);
}

}  // namespace
}  // namespace ptm::pipeline
