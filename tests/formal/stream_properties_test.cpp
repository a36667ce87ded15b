// The handshake for every pattern of valid and ready, for all time.
#include <gtest/gtest.h>

#include "testbench/prove/solver.h"
#include "tests/formal/changed_rtl.h"

namespace ptm::testbench {
namespace {

Answer ask(const char* top, std::vector<std::string> files,
           const std::vector<std::pair<std::string, int>>& parameters = {}) {
  files.push_back(std::string("rtl/formal/") + top + ".sv");
  return prove_always({top, parameters}, files);
}

TEST(StreamChain, LosesDoublesAndHoldsBackNothingWhateverItsLength) {
  for (const int stages : {2, 3, 5, 7, 8}) {
    const Answer answer =
        ask("ptm_stream_chain_properties", rtl_sources("rtl/files.f"), {{"Stages", stages}});
    EXPECT_EQ(answer.verdict, Verdict::holds) << stages;
  }
}

TEST(StreamFifo2, HandsItemsOnInOrder) {
  EXPECT_EQ(ask("ptm_stream_fifo2_properties", rtl_sources("rtl/files.f")).verdict, Verdict::holds);
}

TEST(StreamChain, FailsIfChanged) {
  const std::pair<const char*, const char*> changes[] = {
      {"Stages'(!ready_i)", "Stages'(1'b0)"},                    // never stalls: overwrites
      {"valid_q <= load_o | stalled", "valid_q <= load_o"},      // forgets what stalls
      {"& ~stalled;", "& ~stalled & {Stages{ready_i}};"},        // bubbles stay open
      {"{valid_i, valid_q[1:Stages-1]}", "{Stages{valid_i}}"}};  // makes items up
  for (const auto& [from, to] : changes) {
    const tests::ChangedRtl changed("rtl/stream/ptm_stream_chain.sv", from, to);
    EXPECT_EQ(ask("ptm_stream_chain_properties", changed.files()).verdict, Verdict::fails) << to;
  }
}

TEST(StreamFifo2, FailsIfChanged) {
  const std::pair<const char*, const char*> changes[] = {
      {"(!head_valid_q || pop)", "!head_valid_q"},  // a pop and a push at once: the head is empty
      {"pop && tail_valid_q", "1'b0"},              // never moves up
      {"ready_o = !tail_valid_q", "ready_o = 1'b1"}};
  for (const auto& [from, to] : changes) {
    const tests::ChangedRtl changed("rtl/stream/ptm_stream_fifo2.sv", from, to);
    EXPECT_EQ(ask("ptm_stream_fifo2_properties", changed.files()).verdict, Verdict::fails) << to;
  }
}

}  // namespace
}  // namespace ptm::testbench
