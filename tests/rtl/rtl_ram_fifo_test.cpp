// The FIFO whose items lie in a memory, against a queue: every pin in every cycle.
#include <gtest/gtest.h>
#include <verilated.h>

#include <deque>
#include <random>

#include "Vptm_ram_fifo_2.h"
#include "Vptm_ram_fifo_5.h"
#include "Vptm_ram_fifo_8.h"

namespace ptm::tests {
namespace {

template <class FifoDut, unsigned kDepthOf>
struct Built {
  using Dut = FifoDut;
  static constexpr unsigned kDepth = kDepthOf;
};

template <class Fifo>
class RtlRamFifo : public testing::Test {
 protected:
  RtlRamFifo() { reset(); }
  ~RtlRamFifo() override { dut_.final(); }

  void reset() {
    dut_.clk_i = 0;
    dut_.valid_i = dut_.ready_i = 0;
    dut_.rst_ni = 1;
    dut_.eval();
    dut_.rst_ni = 0;
    dut_.eval();
    edge();
    dut_.rst_ni = 1;
    dut_.eval();
    items_.clear();
  }

  /// A cycle: offers an item or none, takes the oldest or not. It accepts while it is not full at
  /// the cycle's start, and offers what it held then.
  void cycle(bool offer, bool take) {
    const auto item = static_cast<std::uint32_t>(rng_() & 0xFFFFFF);
    dut_.valid_i = offer;
    dut_.data_i = item;  // also where nothing is offered
    dut_.ready_i = take;
    dut_.eval();
    const bool ready = dut_.ready_o != 0, valid = dut_.valid_o != 0;
    const std::uint32_t shown = dut_.data_o;
    edge();
    const std::size_t held = items_.size();
    const std::uint32_t oldest = held == 0 ? 0 : items_.front();
    if (take && held != 0) items_.pop_front();
    if (offer && held < Fifo::kDepth) items_.push_back(item);
    ASSERT_EQ(ready, held < Fifo::kDepth) << held << " items";
    ASSERT_EQ(valid, held != 0);
    if (held != 0) {
      ASSERT_EQ(shown, oldest) << held << " items";
    }
  }

  std::deque<std::uint32_t> items_;
  std::mt19937_64 rng_{1};

 private:
  void edge() {
    dut_.clk_i = 1;
    dut_.eval();
    dut_.clk_i = 0;
    dut_.eval();
  }

  VerilatedContext context_;
  typename Fifo::Dut dut_{&context_};
};

using Depths =
    testing::Types<Built<Vptm_ram_fifo_2, 2>, Built<Vptm_ram_fifo_5, 5>, Built<Vptm_ram_fifo_8, 8>>;
TYPED_TEST_SUITE(RtlRamFifo, Depths);

TYPED_TEST(RtlRamFifo, GivesWhatWasPutInInOrderUnderEveryMixOfGapsAndStalls) {
  std::vector<int> seen(TypeParam::kDepth + 1);  // cycles that began with so many items
  for (int run = 0; run < 200; ++run) {
    const auto offers = this->rng_() % 101, takes = this->rng_() % 101;  // of a hundred cycles
    for (int n = 0; n < 100; ++n) {
      ++seen[this->items_.size()];
      this->cycle(this->rng_() % 100 < offers, this->rng_() % 100 < takes);
      if (this->HasFatalFailure()) return;
    }
    if (run % 5 == 4) this->reset();
  }
  for (std::size_t items = 0; items < seen.size(); ++items) EXPECT_GT(seen[items], 100) << items;
}

TYPED_TEST(RtlRamFifo, HandsOnAnItemACycleWithAnyNumberInside) {
  // Full, it accepts nothing in the cycle in which the oldest leaves, so that many never flow.
  for (unsigned inside = 1; inside < TypeParam::kDepth; ++inside) {
    this->reset();
    while (this->items_.size() < inside) this->cycle(true, false);
    for (int n = 0; n < 50; ++n) this->cycle(true, true);
    EXPECT_EQ(this->items_.size(), inside);
  }
}

TYPED_TEST(RtlRamFifo, KeepsTheOldestThroughAStallWhileOthersAreAdded) {
  for (unsigned first = 1; first <= TypeParam::kDepth; ++first) {
    this->reset();
    while (this->items_.size() < first) this->cycle(true, false);
    this->cycle(false, true);
    for (int n = 0; n < 20; ++n) this->cycle(n % 2 == 0, false);
    while (!this->items_.empty()) this->cycle(false, true);
  }
}

TYPED_TEST(RtlRamFifo, IsEmptyAfterAResetWithAnyNumberInside) {
  for (unsigned inside = 0; inside <= TypeParam::kDepth; ++inside) {
    for (unsigned moved = 0; moved < TypeParam::kDepth; ++moved) {  // from any place of the memory
      for (unsigned n = 0; n < moved; ++n) this->cycle(true, true);
      while (this->items_.size() < inside) this->cycle(true, false);
      this->reset();
      for (int n = 0; n < 3; ++n) this->cycle(false, true);
      for (unsigned n = 0; n <= TypeParam::kDepth; ++n) this->cycle(true, n % 2 == 1);
      while (!this->items_.empty()) this->cycle(false, true);
    }
  }
}

}  // namespace
}  // namespace ptm::tests
