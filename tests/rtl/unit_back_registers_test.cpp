// The unit's registers in RTL: every field where it belongs, the check of draws, status, counters.
#include <gtest/gtest.h>

#include "model/reference/unit/register_map.h"
#include "tests/reference/unit_scene.h"
#include "tests/rtl/unit_back_bench.h"
#include "tests/rtl/unit_back_variants.h"

namespace ptm::tests {
namespace {

using reference::Combine;
using reference::Draw;
using reference::TextureFormat;
using reference::TextureLevels;

class RtlUnitRegisters : public testing::Test {
 protected:
  void write(const Draw& draw, int number) {
    for (const reference::RegisterWrite& w : reference::register_writes(draw, number)) {
      bench_.write(w.address, w.data);
    }
  }
  /// Error bits of draw 0 after it was written and looked at.
  unsigned check(const Draw& draw, std::uint64_t lines) {
    bench_.write(0x1001, static_cast<std::uint32_t>(lines));
    write(draw, 0);
    bench_.wait_for_check();
    return bench_.read(0x1002);
  }

  /// A draw with every field of random bits.
  Draw random_draw() {
    Draw d;
    d.format = static_cast<TextureFormat>(in(0, 7));
    d.bilinear = in(0, 1) != 0;
    d.mip = static_cast<reference::Mip>(in(0, 3));
    d.wrap_u = static_cast<reference::Wrap>(in(0, 3));
    d.wrap_v = static_cast<reference::Wrap>(in(0, 3));
    d.combine = static_cast<Combine>(in(0, 7));
    d.color = in(0, 1) != 0;
    d.color_lod = in(-4096, 4095);
    for (TextureLevels* t : {&d.map, &d.color_texture}) {
      t->width = in(0, 8191);
      t->height = in(0, 8191);
      t->levels = in(0, 15);
      for (auto& base : t->base) base = static_cast<std::uint32_t>(in(0, (1 << 26) - 1));
    }
    for (auto& b : d.bias) b = in(0, 4095);
    for (auto& s : d.shift) s = in(-16, 15);
    d.palette = in(0, 3);
    d.ka = in(0, 511);
    d.kd = in(0, 511);
    d.ks = in(0, 511);
    return d;
  }

  /// The descriptor that the RTL hands to its other blocks.
  Draw seen(unsigned number) {
    auto& dut = bench_.dut;
    dut.view_i = 1;
    dut.draw_i = static_cast<CData>(number);
    dut.eval();
    Draw d;
    d.format = static_cast<TextureFormat>(dut.draw_format_o);
    d.bilinear = dut.draw_bilinear_o != 0;
    d.mip = static_cast<reference::Mip>(dut.draw_mip_o);
    d.wrap_u = static_cast<reference::Wrap>(dut.draw_wrap_u_o);
    d.wrap_v = static_cast<reference::Wrap>(dut.draw_wrap_v_o);
    d.combine = static_cast<Combine>(dut.draw_combine_o);
    d.color = dut.draw_color_o != 0;
    d.color_lod = static_cast<std::int32_t>(dut.draw_color_lod_o);
    for (unsigned t = 0; t < 2; ++t) {
      TextureLevels& texture = t == 0 ? d.map : d.color_texture;
      texture.width = dut.draw_width_o[t];
      texture.height = dut.draw_height_o[t];
      texture.levels = dut.draw_levels_o[t];
      for (unsigned l = 0; l < reference::kLevelsMax; ++l) {
        texture.base[l] = dut.draw_base_o[13 * t + l];
      }
    }
    for (unsigned i = 0; i < 6; ++i) {
      d.bias[i] = dut.draw_bias_o[i];
      d.shift[i] = static_cast<std::int32_t>(dut.draw_shift_o[i]);
    }
    d.palette = dut.draw_palette_o;
    d.ka = dut.draw_ka_o;
    d.kd = dut.draw_kd_o;
    d.ks = dut.draw_ks_o;
    return d;
  }

  /// An LRGB map of 20 x 9 with all its levels, and a picture of 5 x 7, in the lines that they
  /// need.
  static Draw legal() {
    Draw d;
    d.color = true;
    d.combine = Combine::modulate;
    d.map = {20, 9, 5, {0, 45, 54, 57, 60}};
    d.color_texture = {5, 7, 3, {63, 67, 68}};
    return d;
  }
  static constexpr std::uint64_t kLegalLines = 69;

  /// Changes one or two things in a legal draw, to what is illegal more often than not.
  void spoil(Draw& d) {
    for (int changes = in(0, 2); changes > 0; --changes) {
      TextureLevels& t = in(0, 1) != 0 ? d.map : d.color_texture;
      switch (in(0, 9)) {
        case 0:
          t.width = in(0, 1) != 0 ? 0 : 4096 + in(0, 1);
          break;
        case 1:
          t.height = in(0, 1) != 0 ? 0 : 4096 + in(0, 1);
          break;
        case 2:
          t.levels = in(0, 15);
          break;
        case 3:
          t.base[static_cast<std::size_t>(in(0, 12))] = static_cast<std::uint32_t>(in(0, 70));
          break;
        case 4:
          d.format = static_cast<TextureFormat>(in(0, 7));
          break;
        case 5:
          d.mip = static_cast<reference::Mip>(in(0, 3));
          break;
        case 6:
          (in(0, 1) != 0 ? d.wrap_u : d.wrap_v) = static_cast<reference::Wrap>(in(0, 3));
          break;
        case 7:
          d.combine = static_cast<Combine>(in(0, 7));
          break;
        case 8:
          d.color = false;
          break;
        default:
          t.height = in(1, 40);
      }
    }
  }

  int in(int low, int high) { return std::uniform_int_distribution(low, high)(rng_); }

  UnitBack<BackDefault::Dut> bench_;
  std::mt19937_64 rng_{1};
};

TEST_F(RtlUnitRegisters, EveryFieldOfEveryDrawLandsWhereTheOtherBlocksReadIt) {
  for (int round = 0; round < 50; ++round) {
    std::array<Draw, 4> draws;
    for (int d = 0; d < 4; ++d) {
      draws[static_cast<std::size_t>(d)] = random_draw();
      write(draws[static_cast<std::size_t>(d)], d);
    }
    for (unsigned d = 0; d < 4; ++d) EXPECT_TRUE(seen(d) == draws[d]) << "draw " << d;
  }
}

TEST_F(RtlUnitRegisters, ALegalDrawPassesInTheLinesItNeedsAndFailsInOneLess) {
  EXPECT_EQ(check_draw(legal(), kLegalLines), 0U);
  EXPECT_EQ(check(legal(), kLegalLines), 0U);
  EXPECT_FALSE(bench_.dut.error_o);
  EXPECT_EQ(check(legal(), kLegalLines - 1), 4U);
  EXPECT_TRUE(bench_.dut.error_o);
  EXPECT_EQ(check(legal(), kLegalLines), 0U);
  EXPECT_FALSE(bench_.dut.error_o);
}

TEST_F(RtlUnitRegisters, TheCheckFindsEachLevelOfEitherTextureThatEndsBeyondTheMemory) {
  for (unsigned level = 0; level < 5; ++level) {
    Draw d = legal();
    d.map.base[level] = (1U << 26) - 1;
    EXPECT_EQ(check(d, kLegalLines), 4U) << "map, level " << level;
    d = legal();
    d.color_texture.base[level] = (1U << 26) - 1;
    EXPECT_EQ(check(d, kLegalLines), level < 3 ? 4U : 0U) << "colour, level " << level;
  }
}

TEST_F(RtlUnitRegisters, TheCheckFindsWhatTheReferenceFindsOnRandomAndOnNearlyLegalDraws) {
  std::array<int, 16> found{};
  for (int n = 0; n < 4000; ++n) {
    Draw d = n % 8 == 0 ? random_draw() : legal();
    if (n % 8 != 0) spoil(d);
    const std::uint64_t lines = n % 3 == 0 ? std::uint64_t{1} << 26 : kLegalLines;
    const unsigned expected = check_draw(d, lines);
    ++found[expected];
    ASSERT_EQ(check(d, lines), expected) << n;
    ASSERT_EQ(bench_.dut.error_o, expected != 0);
  }
  for (const unsigned code : {0U, 1U, 2U, 3U, 4U, 8U, 9U, 10U, 11U}) {
    EXPECT_GT(found[code], 10) << "error bits " << code;
  }
}

TEST_F(RtlUnitRegisters, TheCheckTakesTwentySixCyclesADrawAndIsBusyMeanwhile) {
  bench_.write(0x1001, kLegalLines);
  write(legal(), 2);
  EXPECT_EQ(bench_.read(0x1003), 1U);
  EXPECT_EQ(bench_.wait_for_check(), 1U + 26U);
  EXPECT_EQ(bench_.read(0x1003), 0U);
}

TEST_F(RtlUnitRegisters, DrawsWrittenWhileOneIsLookedAtAreLookedAtToo) {
  bench_.write(0x1001, kLegalLines);
  std::uint32_t expected = 0;
  for (int d = 0; d < 4; ++d) {
    Draw draw = legal();
    if (d == 1) draw.map.width = 4097;
    if (d == 3) draw.map.levels = 6;
    expected |= check_draw(draw, kLegalLines) << (8 * d);
    draw.format = static_cast<TextureFormat>(7);
    write(draw, d);
  }
  EXPECT_EQ(bench_.wait_for_check(), 27U);  // the last one's
  EXPECT_EQ(bench_.read(0x1002), expected | 0x08080808U);
  const std::uint32_t control = 1U | 1U << 5 | 1U << 10 | 1U << 13;
  for (const unsigned at : {0U, 64U, 128U, 192U}) bench_.write(at, control);
  bench_.wait_for_check();
  EXPECT_EQ(bench_.read(0x1002), expected);
  EXPECT_EQ(expected, 1U << 8 | 2U << 24);
  EXPECT_TRUE(bench_.dut.error_o);
}

TEST_F(RtlUnitRegisters, AControlWrittenDuringItsOwnCheckIsLookedAtAnew) {
  const std::uint32_t control = 1U | 1U << 5 | 1U << 10 | 1U << 13;
  for (int after = 0; after < 30; ++after) {
    check(legal(), kLegalLines);
    bench_.write(0, control | 7U);
    for (int n = 0; n < after; ++n) bench_.edge();
    bench_.write(0, control);
    bench_.wait_for_check();
    ASSERT_EQ(bench_.read(0x1002), 0U) << after;
    bench_.write(0, control);
    for (int n = 0; n < after; ++n) bench_.edge();
    bench_.write(0, control | 7U);
    bench_.wait_for_check();
    ASSERT_EQ(bench_.read(0x1002), 8U) << after;
  }
}

TEST_F(RtlUnitRegisters, ADrawThatWasNotWrittenIsNoError) {
  EXPECT_EQ(bench_.read(0x1002), 0U);
  EXPECT_FALSE(bench_.dut.error_o);
  EXPECT_FALSE(bench_.dut.checking_o);
}

TEST_F(RtlUnitRegisters, TheTagOfTheFirstResponseThatNobodyWaitsForStaysUntilItIsCleared) {
  auto& dut = bench_.dut;
  for (const unsigned tag : {0xA5U, 0x11U}) {
    dut.mem_error_i = 1;
    dut.mem_error_tag_i = static_cast<CData>(tag);
    dut.eval();
    bench_.edge();
    dut.mem_error_i = 0;
    bench_.edge();
    EXPECT_EQ(bench_.read(0x1003), 2U | 0xA5U << 8);
  }
  bench_.write(0x1000, 1);
  EXPECT_EQ(bench_.read(0x1003), 2U | 0xA5U << 8);
  bench_.write(0x1000, 2);
  EXPECT_EQ(bench_.read(0x1003), 0U);
  dut.busy_i = 1;
  EXPECT_EQ(bench_.read(0x1003), 1U);
}

TEST_F(RtlUnitRegisters, TheCommandsArePulsesInTheCycleOfTheirWrite) {
  auto& dut = bench_.dut;
  for (const unsigned command : {0U, 1U, 2U, 3U}) {
    dut.reg_we_i = 1;
    dut.reg_addr_i = 0x1000;
    dut.reg_wdata_i = command;
    dut.eval();
    EXPECT_EQ(dut.invalidate_o, command & 1U);
    EXPECT_EQ(dut.clear_o, command >> 1);
    bench_.edge();
    dut.reg_we_i = 0;
    dut.eval();
    EXPECT_FALSE(dut.invalidate_o || dut.clear_o);
  }
  dut.reg_we_i = 1;
  dut.reg_addr_i = 0x1001;
  dut.eval();
  EXPECT_FALSE(dut.invalidate_o || dut.clear_o);
}

TEST_F(RtlUnitRegisters, EveryEventIsSetByItsCauseClearedByOneWriteAndNotLostInBetween) {
  namespace events = reference::events;
  auto& dut = bench_.dut;
  const auto cause = [&](std::uint32_t bits) {
    dut.last_taken_i = (bits & events::kIdle) != 0;
    dut.mem_error_i = (bits & events::kWrongTag) != 0;
    dut.mem_failed_i = (bits & events::kFailedLine) != 0;
  };
  const std::uint32_t pins = events::kIdle | events::kWrongTag | events::kFailedLine;
  for (std::uint32_t bits = 0; bits <= pins; ++bits) {
    if ((bits & ~pins) != 0) continue;
    for (std::uint32_t enable = 0; enable <= events::kAll; ++enable) {
      bench_.write(0x1009, enable);
      cause(bits);
      bench_.write(0x1008, events::kAll);  // set and cleared in one cycle: set
      cause(0);
      EXPECT_EQ(bench_.read(0x1008), bits);
      EXPECT_EQ(dut.irq_o, (bits & enable) != 0) << bits << ' ' << enable;
      bench_.write(0x1008, ~bits);
      EXPECT_EQ(bench_.read(0x1008), bits) << "cleared by the other bits";
      bench_.write(0x1008, bits);
      EXPECT_EQ(bench_.read(0x1008), 0U);
      EXPECT_FALSE(dut.irq_o);
    }
  }
  check(legal(), kLegalLines);
  EXPECT_EQ(bench_.read(0x1008), 0U);
  check(legal(), kLegalLines - 1);
  EXPECT_EQ(bench_.read(0x1008), events::kDrawError);
  bench_.write(0x1008, events::kDrawError);
  EXPECT_EQ(bench_.read(0x1008), 0U);
}

TEST_F(RtlUnitRegisters, WhileFragmentsAreInsideOnlyWhatTheyDoNotReadIsWritten) {
  auto& dut = bench_.dut;
  struct Range {
    unsigned first, last;
    bool shared;
  };
  const std::array<Range, 16> ranges{{{0x0, 0xff, true},
                                      {0x100, 0xfff, false},
                                      {0x1001, 0x1001, true},
                                      {0x1002, 0x1003, false},
                                      {0x1004, 0x1004, true},
                                      {0x1005, 0x1008, false},
                                      {0x1009, 0x1009, false},
                                      {0x100a, 0x27ff, false},
                                      {0x2800, 0x287f, true},
                                      {0x2880, 0x2fff, false},
                                      {0x3000, 0x33ff, true},
                                      {0x3400, 0x3fff, false},
                                      {0x4000, 0x47ff, true},
                                      {0x4800, 0x7fff, false},
                                      {0x8000, 0x8001, true},
                                      {0xfffe, 0xffff, true}}};
  for (const bool entering : {false, true}) {
    dut.busy_i = !entering;
    dut.accepted_i = entering;
    for (const Range& range : ranges) {
      for (unsigned address = range.first; address <= range.last; ++address) {
        bench_.write(address, 0);
        EXPECT_EQ(bench_.read(0x1008), range.shared ? 16U : 0U) << std::hex << address;
        bench_.write(0x1008, 16);
      }
    }
    bench_.write(0x1001, 77);
    EXPECT_EQ(bench_.read(0x1001), 0U);
    bench_.write(0x1009, 3);
    EXPECT_EQ(bench_.read(0x1009), 3U);
    bench_.write(0x1008, 16);
    bench_.write(0x1000, 2);
    EXPECT_EQ(bench_.read(0x1008), 0U) << "counters may be cleared";
    for (const unsigned command : {1U, 3U}) {
      dut.reg_we_i = 1;
      dut.reg_addr_i = 0x1000;
      dut.reg_wdata_i = command;
      dut.eval();
      EXPECT_FALSE(dut.invalidate_o);
      EXPECT_EQ(dut.clear_o, command >> 1);
      bench_.edge();
      dut.reg_we_i = 0;
      EXPECT_EQ(bench_.read(0x1008), 16U);
      bench_.write(0x1008, 16);
    }
    bench_.write(0x1009, 0);
  }
  dut.busy_i = dut.accepted_i = 0;
  bench_.write(0x1001, 77);
  EXPECT_EQ(bench_.read(0x1001), 77U);
  EXPECT_EQ(bench_.read(0x1008), 0U);
}

TEST_F(RtlUnitRegisters, EveryCounterIsReadInTwoHalvesAndNothingLiesBehindThem) {
  for (unsigned n = 0; n < reference::kUnitCounters; ++n) {
    bench_.dut.counters_i[n] = 0x1234567800000000ULL * (n + 1) + n * 77 + 5;
  }
  for (unsigned n = 0; n < reference::kUnitCounters; ++n) {
    EXPECT_EQ(bench_.read(0x2000 + 2 * n), static_cast<std::uint32_t>(n * 77 + 5)) << n;
    EXPECT_EQ(bench_.read(0x2001 + 2 * n),
              static_cast<std::uint32_t>((0x1234567800000000ULL * (n + 1)) >> 32))
        << n;
  }
  for (const unsigned address : {0x2000U + 2U * unsigned{reference::kUnitCounters}, 0x2080U,
                                 0x2800U, 0x1000U, 0x1001U, 0x3000U, 0x0U, 0xA000U}) {
    EXPECT_EQ(bench_.read(address), 0U) << address;
  }
}

}  // namespace
}  // namespace ptm::tests
