// Every stage of effects by itself, against the reference's: values, pixels that it does not act
// on, multiplies, latency, what it holds.
#include <gtest/gtest.h>
#include <verilated.h>

#include <optional>
#include <random>
#include <vector>

#include "Vptm_stages_narrow.h"
#include "Vptm_stages_wide.h"
#include "model/reference/effects/add.h"
#include "model/reference/effects/modulate.h"
#include "model/reference/effects/power.h"

namespace ptm::tests {
namespace {

using reference::Value;

struct Wide {
  using Dut = Vptm_stages_wide;
  static constexpr reference::EvalConfig config{.lum_bits = 10, .lum_frac = 4};
};
struct Narrow {
  using Dut = Vptm_stages_narrow;
  static constexpr reference::EvalConfig config{
      .rounding = reference::Rounding::truncate, .lum_bits = 8, .lum_frac = 0};
};

enum Stage : unsigned { kPower, kModulate, kAdd };
constexpr std::array<unsigned, 3> kRegisters{3, 1, 1};

struct Item {
  std::uint64_t beside = 0;  ///< x, y, alpha, flags: untouched
  unsigned draw = 0;
  reference::effects::StagePixel<> pixel;
  std::array<Value, reference::kExtraPasses> value{};
  bool operator==(const Item& o) const {
    return beside == o.beside && draw == o.draw && pixel.rgb == o.pixel.rgb &&
           pixel.addend == o.pixel.addend && value == o.value;
  }
};

template <class Variant>
class RtlEffectStages : public testing::Test {
 protected:
  static constexpr reference::EvalConfig config = Variant::config;
  static constexpr Value kMost = (Value{1} << (config.lum_bits + config.lum_frac)) - 1;

  RtlEffectStages() {
    dut_.rst_ni = 1;
    dut_.eval();
    dut_.rst_ni = 0;
    edge();
    dut_.rst_ni = 1;
    for (unsigned d = 0; d < reference::kDraws; ++d) {
      for (auto& entry : tables_[d]) entry = static_cast<std::uint16_t>(in(0, 4095));
      draws_[d].ks = d == 0 ? 511 : in(0, 511);
      draws_[d].effects.argument = d % 2;  // three channels
      for (unsigned e = 0; e < 256; ++e) {
        dut_.table_we_i = 1;
        dut_.table_addr_i = static_cast<SData>(256 * d + e);
        dut_.table_data_i = tables_[d][e];
        edge();
      }
      dut_.ks_i[d] = static_cast<SData>(draws_[d].ks);
      dut_.argument_i[d] = draws_[d].effects.argument;
    }
    dut_.table_we_i = 0;
    act(0b1011);
  }
  ~RtlEffectStages() override { dut_.final(); }

  void act(unsigned draws) {
    acts_ = draws;
    dut_.acts_i = static_cast<CData>(draws);
  }
  Value in(Value low, Value high) { return std::uniform_int_distribution<Value>(low, high)(rng_); }

  Item item() {
    Item out;
    out.beside = static_cast<std::uint64_t>(in(0, (Value{1} << 38) - 1));
    out.draw = static_cast<unsigned>(in(0, 3));
    for (auto& c : out.pixel.rgb) c = in(0, 255);
    for (auto& v : out.value) v = in(0, 1) != 0 ? in(0, kMost) : in(0, 256 << config.lum_frac);
    const Value alike = in(0, 8191);
    for (auto& a : out.pixel.addend) a = out.draw % 2 == 1 ? in(0, 8191) : alike;
    for (auto& v : out.value) v = std::min(v, kMost);
    return out;
  }

  Item expected(Stage stage, Item i) {
    if ((acts_ >> i.draw & 1U) == 0) return i;
    const reference::effects::StageInput<> seen{config, draws_[i.draw], tables_[i.draw], i.value};
    switch (stage) {
      case kPower:
        reference::effects::power::apply(seen, i.pixel);
        break;
      case kModulate:
        reference::effects::modulate::apply(seen, i.pixel);
        break;
      case kAdd:
        reference::effects::add::apply(seen, i.pixel);
        break;
    }
    return i;
  }
  unsigned multiplies(Stage stage, const Item& i) {
    if ((acts_ >> i.draw & 1U) == 0) return 0;
    const reference::Draw& draw = draws_[i.draw];
    return stage == kPower      ? reference::effects::power::multiplies(config, draw)
           : stage == kModulate ? reference::effects::modulate::multiplies(config, draw)
                                : reference::effects::add::multiplies(config, draw);
  }

  struct Seen {
    bool accepted = false;
    std::optional<Item> taken;
  };
  /// One cycle: that item offered, or none; outputs taken if ready.
  Seen cycle(Stage stage, const Item* offered, bool ready) {
    dut_.stage_i = stage;
    dut_.valid_i = offered != nullptr;
    if (offered != nullptr) drive(*offered);
    dut_.ready_i = ready;
    dut_.eval();
    Seen seen;
    seen.accepted = offered != nullptr && dut_.ready_o != 0;
    counted_ += dut_.inc_o;
    if (dut_.valid_o != 0 && ready) seen.taken = shown();
    edge();
    return seen;
  }

  void expect_stream(Stage stage, const std::vector<Item>& items) {
    std::size_t sent = 0, taken = 0;
    unsigned expected_multiplies = 0;
    counted_ = 0;
    while (taken < items.size()) {
      const bool offers = sent < items.size() && in(0, 3) != 0;
      const Seen seen = cycle(stage, offers ? &items[sent] : nullptr, in(0, 3) != 0);
      if (seen.accepted) expected_multiplies += multiplies(stage, items[sent++]);
      if (!seen.taken) continue;
      const Item want = expected(stage, items[taken]);
      ASSERT_EQ(*seen.taken, want)
          << "item " << taken << ", draw " << want.draw << ", value " << want.value[0] << ' '
          << want.value[1] << ": addend " << seen.taken->pixel.addend[0] << ", expected "
          << want.pixel.addend[0] << "; red " << seen.taken->pixel.rgb[0] << ", expected "
          << want.pixel.rgb[0];
      ++taken;
    }
    EXPECT_EQ(counted_, expected_multiplies);
  }

  std::mt19937_64 rng_{7};
  std::array<reference::Draw, reference::kDraws> draws_{};
  std::array<reference::EffectTable, reference::kDraws> tables_{};
  unsigned acts_ = 0;
  std::uint64_t counted_ = 0;
  typename Variant::Dut dut_;

 private:
  void edge() {
    dut_.clk_i = 1;
    dut_.eval();
    dut_.clk_i = 0;
    dut_.eval();
  }
  /// pixel_t: x, y, draw, rgb (red lowest), alpha, flags, from the highest.
  void drive(const Item& i) {
    std::uint64_t rgb = 0;
    for (unsigned c = 0; c < 3; ++c) rgb |= static_cast<std::uint64_t>(i.pixel.rgb[c]) << (8 * c);
    dut_.pixel_i =
        (i.beside >> 10) << 36 | std::uint64_t{i.draw} << 34 | rgb << 10 | (i.beside & 1023U);
    for (unsigned c = 0; c < 3; ++c) dut_.addend_i[c] = static_cast<SData>(i.pixel.addend[c]);
    for (unsigned k = 0; k < 4; ++k) dut_.value_i[k] = static_cast<SData>(i.value[k]);
  }
  Item shown() {
    Item i;
    const std::uint64_t pixel = dut_.pixel_o;
    i.beside = (pixel >> 36) << 10 | (pixel & 1023U);
    i.draw = static_cast<unsigned>(pixel >> 34 & 3U);
    for (unsigned c = 0; c < 3; ++c) {
      i.pixel.rgb[c] = static_cast<Value>(pixel >> (10 + 8 * c) & 255U);
      i.pixel.addend[c] = dut_.addend_o[c];
    }
    for (unsigned k = 0; k < 4; ++k) i.value[k] = dut_.value_o[k];
    return i;
  }
};

using Variants = testing::Types<Wide, Narrow>;
TYPED_TEST_SUITE(RtlEffectStages, Variants);

TYPED_TEST(RtlEffectStages, PowerIsTheReferencesForEveryLuminance) {
  std::vector<Item> items;
  for (Value v = 0; v <= this->kMost; ++v) {
    items.push_back(this->item());
    items.back().value[0] = v;
  }
  this->expect_stream(kPower, items);
}

TYPED_TEST(RtlEffectStages, PowerHoldsWhatTheWidestTableAndWeightGive) {
  Item item = this->item();
  item.draw = 0;  // ks 511
  item.value[0] = this->kMost;
  this->tables_[0].fill(4095);
  for (unsigned e = 0; e < 256; ++e) {
    this->dut_.table_we_i = 1;
    this->dut_.table_addr_i = static_cast<SData>(e);
    this->dut_.table_data_i = 4095;
    (void)this->cycle(kPower, nullptr, true);
  }
  this->dut_.table_we_i = 0;
  this->expect_stream(kPower, {item});
  EXPECT_EQ(this->expected(kPower, item).pixel.addend[0], 8174);  // 13 bits hold 8191
}

TYPED_TEST(RtlEffectStages, ModulateIsTheReferencesForEveryLuminanceOfAChannel) {
  std::vector<Item> items;
  for (Value v = 0; v <= this->kMost; ++v) {
    items.push_back(this->item());
    items.back().value[1 + static_cast<unsigned>(v % 3)] = v;
    items.push_back(this->item());
    items.back().draw = 0;  // one channel
    items.back().pixel.addend.fill(this->in(0, 8191));
    items.back().value[1] = v;
  }
  this->expect_stream(kModulate, items);
}

TYPED_TEST(RtlEffectStages, AddIsTheReferencesForEveryAddendOnAnyColor) {
  std::vector<Item> items;
  for (Value a = 0; a < 8192; ++a) {
    items.push_back(this->item());
    items.back().pixel.addend[static_cast<unsigned>(a % 3)] = a;
  }
  this->expect_stream(kAdd, items);
}

TYPED_TEST(RtlEffectStages, LeaveAPixelThatTheyDoNotActOnAsItIs) {
  this->act(0);
  for (const Stage stage : {kPower, kModulate, kAdd}) {
    std::vector<Item> items(100);
    for (Item& i : items) i = this->item();
    this->expect_stream(stage, items);
    EXPECT_EQ(this->counted_, 0U);
  }
}

TYPED_TEST(RtlEffectStages, HaveTheLatencyOfTheirRegistersAndHoldAsManyPixelsWhenBlocked) {
  for (const Stage stage : {kPower, kModulate, kAdd}) {
    const Item item = this->item();
    unsigned latency = 0;
    EXPECT_TRUE(this->cycle(stage, &item, true).accepted);
    while (!this->cycle(stage, nullptr, true).taken) ++latency;
    EXPECT_EQ(latency + 1, kRegisters[stage]);
    // A pixel a cycle, without a gap
    for (unsigned n = 0; n < 20; ++n) {
      const auto seen = this->cycle(stage, &item, true);
      EXPECT_TRUE(seen.accepted);
      EXPECT_EQ(seen.taken.has_value(), n >= kRegisters[stage]);
    }
    while (this->cycle(stage, nullptr, true).taken) {
    }
    unsigned held = 0;
    for (unsigned n = 0; n < 20; ++n) held += this->cycle(stage, &item, false).accepted;
    EXPECT_EQ(held, kRegisters[stage]);
    for (unsigned n = 0; n < held; ++n) {
      EXPECT_TRUE(this->cycle(stage, nullptr, true).taken) << "kept " << n;
    }
    EXPECT_FALSE(this->cycle(stage, nullptr, true).taken);
  }
}

}  // namespace
}  // namespace ptm::tests
