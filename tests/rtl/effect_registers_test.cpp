// The registers of a unit that is built with a part of what effects need: two sets, three passes,
// `modulate`, no half-vector. docs/spec/effects.md, Registers and Legal.
#include <gtest/gtest.h>
#include <verilated.h>

#include <random>
#include <string>

#include "Vptm_registers_part.h"
#include "model/reference/unit/unit_memory.h"

namespace ptm::tests {
namespace {

constexpr reference::UnitConfig kPart{.extra_sets = 2, .extra_passes = 3, .stages = 2};
constexpr std::uint64_t kLines = 100000;

class RtlEffectRegisters : public testing::Test {
 protected:
  RtlEffectRegisters() {
    dut_.rst_ni = 1;
    dut_.eval();
    dut_.rst_ni = 0;
    edge();
    dut_.rst_ni = 1;
    write(0x1001, static_cast<std::uint32_t>(kLines));
  }
  ~RtlEffectRegisters() override { dut_.final(); }

  void write(unsigned address, std::uint32_t data) {
    dut_.reg_we_i = 1;
    dut_.reg_addr_i = static_cast<SData>(address);
    dut_.reg_wdata_i = data;
    dut_.eval();
    edge();
    dut_.reg_we_i = 0;
  }
  void edge() {
    dut_.clk_i = 1;
    dut_.eval();
    dut_.clk_i = 0;
    dut_.eval();
  }
  /// Error bits of that draw, written as draw `number` over whatever stood there.
  unsigned errors(const reference::Draw& draw, int number) {
    const unsigned d = 64 * static_cast<unsigned>(number);
    for (const unsigned cleared : {12U, 13U, 14U}) write(d + cleared, 0);
    for (const auto& w : reference::register_writes(draw, number)) write(w.address, w.data);
    for (int cycle = 0; cycle < 100 && dut_.checking_o; ++cycle) edge();
    dut_.reg_addr_i = 0x1002;
    dut_.eval();
    return dut_.reg_rdata_o >> (8 * number) & 15U;
  }

  static reference::Draw legal() {
    reference::Draw draw;
    draw.map = {.width = 16, .height = 16, .levels = 5, .base = {0, 500, 600, 700, 800}};
    return draw;
  }

  Vptm_registers_part dut_;
};

TEST_F(RtlEffectRegisters, RefuseWhatExceedsTheBuildOrNamesWhatIsNotThere) {
  using reference::TextureFormat;
  struct Case {
    const char* what;
    reference::DrawEffects effects;
    TextureFormat format;
    unsigned bits;
  };
  const auto passes = [](int count, int set, bool half) {
    reference::DrawEffects e;
    e.sets = 2;
    e.passes = count;
    e.pass.fill({2, false});
    if (count > 0) e.pass[static_cast<std::size_t>(count - 1)] = {set, half};
    return e;
  };
  const auto sets = [](int count) { return reference::DrawEffects{.sets = count}; };
  const auto stages = [](unsigned mask) { return reference::DrawEffects{.stages = mask}; };
  const std::array<Case, 19> cases{
      {{"nothing", {}, TextureFormat::lrgb, 0},
       {"all sets", sets(2), TextureFormat::lrgb, 0},
       {"a set too many", sets(3), TextureFormat::lrgb, 8},
       {"seven sets", sets(7), TextureFormat::lrgb, 8},
       {"a set without a map", sets(1), TextureFormat::none, 8},
       {"all passes", passes(3, 2, false), TextureFormat::rgb, 0},
       {"a pass too many", passes(4, 2, false), TextureFormat::rgb, 8},
       {"a set above the draw's", passes(3, 3, false), TextureFormat::lrgb, 8},
       {"the last pass with a half-vector", passes(3, 2, true), TextureFormat::lrgb, 8},
       {"the first pass with a half-vector", passes(1, 1, true), TextureFormat::palette_rgb, 8},
       {"the map's polynomial", passes(3, 0, false), TextureFormat::lrgb, 0},
       {"a palettised map's", passes(3, 0, false), TextureFormat::palette_lrgb, 0},
       {"one of an RGB map's", passes(3, 0, false), TextureFormat::rgb, 8},
       {"of a palettised RGB map's", passes(2, 0, false), TextureFormat::palette_rgb, 8},
       {"the built stage", stages(2), TextureFormat::rgb, 0},
       {"a stage that is not", stages(1), TextureFormat::lrgb, 8},
       {"a stage that is not, too", stages(6), TextureFormat::lrgb, 8},
       {"the highest stage", stages(128), TextureFormat::lrgb, 8},
       {"a stage without a map", stages(2), TextureFormat::none, 0}}};
  for (const Case& c : cases) {
    reference::Draw draw = legal();
    draw.format = c.format;
    draw.effects = c.effects;
    if (c.format == TextureFormat::none) {
      draw.color = true;
      draw.combine = reference::Combine::replace;
    }
    EXPECT_EQ(check_draw(draw, kLines, kPart), c.bits) << c.what;
    for (const int number : {0, 3}) EXPECT_EQ(errors(draw, number), c.bits) << c.what;
  }
}

TEST_F(RtlEffectRegisters, LookAtNoPassBeyondThoseOfTheDraw) {
  reference::Draw draw = legal();
  draw.effects.sets = 1;
  draw.effects.passes = 1;
  draw.effects.pass = {{{1, false}, {7, true}, {0, true}, {7, true}}};
  EXPECT_EQ(check_draw(draw, kLines, kPart), 0U);
  EXPECT_EQ(errors(draw, 1), 0U);
}

TEST_F(RtlEffectRegisters, CountTheSetsPlanesAgainstTheMemory) {
  for (int sets = 0; sets <= 2; ++sets) {
    reference::Draw draw = legal();
    draw.effects.sets = sets;
    draw.map.levels = 1;
    const std::uint32_t lines = 16 * (3 + 2 * static_cast<std::uint32_t>(sets));
    draw.map.base[0] = static_cast<std::uint32_t>(kLines) - lines;
    EXPECT_EQ(errors(draw, 2), 0U) << sets;
    ++draw.map.base[0];
    EXPECT_EQ(errors(draw, 2), unsigned{reference::kBadAddress}) << sets;
  }
}

TEST_F(RtlEffectRegisters, AgreeWithTheReferenceOnAnyDraw) {
  std::mt19937 rng(3);
  const auto below = [&rng](int limit) {
    return static_cast<int>(rng() % static_cast<unsigned>(limit));
  };
  std::array<int, 16> seen{};
  for (int n = 0; n < 5000; ++n) {
    reference::Draw draw = legal();
    draw.format = static_cast<reference::TextureFormat>(below(6));
    draw.color = below(2) != 0;
    draw.combine = draw.color ? reference::Combine::replace : reference::Combine::none;
    draw.map.base[0] = static_cast<std::uint32_t>(kLines) - 16 * static_cast<unsigned>(below(12));
    reference::DrawEffects& e = draw.effects;
    e.sets = below(4);
    e.passes = below(4);
    for (auto& pass : e.pass) pass = {below(4), below(8) == 0};
    e.stages = below(3) == 0 ? static_cast<unsigned>(below(4)) : 0;
    const unsigned bits = check_draw(draw, kLines, kPart);
    ++seen[bits];
    EXPECT_EQ(errors(draw, n % 4), bits) << n;
  }
  EXPECT_GT(seen[0], 100);
  EXPECT_GT(seen[4], 100);
  EXPECT_GT(seen[8], 100);
}

}  // namespace
}  // namespace ptm::tests
