#pragma once
#include <verilated.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

/// The counters near 2^32 and 2^64, for a Verilated ptm_registers_counters with a stage of effects.
/// Includes nothing of this project: tests compile it against changed RTL too.
namespace ptm::tests {

inline constexpr unsigned kLimitCounters = 38;

/// Every element of Verilator's array.
template <class Value, std::size_t kSize>
void fill(VlUnpacked<Value, kSize>& values, std::uint64_t value) {
  for (std::size_t n = 0; n < kSize; ++n) values[n] = value;
}

template <class Pin>
void set(Pin& pin, unsigned value) {
  pin = static_cast<Pin>(value);
}

/// Random increments on a unit whose counters stand at `start`, all read at the end.
template <class Dut>
std::array<std::uint64_t, kLimitCounters> count_from(std::uint64_t start) {
  VerilatedContext context;
  Dut dut(&context);
  const auto edge = [&dut] {
    set(dut.clk_i, 1);
    dut.eval();
    set(dut.clk_i, 0);
    dut.eval();
  };
  dut.rst_ni = 1;
  dut.eval();
  dut.rst_ni = 0;
  edge();
  dut.rst_ni = 1;
  edge();
  fill(dut.rootp->ptm_registers_counters__DOT__count_q, start);
  fill(dut.rootp->ptm_registers_counters__DOT__draw_count_q, start);
  dut.rootp->ptm_registers_counters__DOT__gen_effects__DOT__effects_q = start;
  std::mt19937 rng(7);
  const auto in = [&rng](unsigned most) { return static_cast<unsigned>(rng() % (most + 1)); };
  unsigned inside = 0;
  for (int cycle = 0; cycle < 2000; ++cycle) {
    set(dut.inside_i, inside > 0 ? 1 : 0);
    set(dut.accepted_i, inside < 3 && in(3) == 0 ? 1 : 0);
    set(dut.taken_i, inside > 0 && in(2) == 0 ? 1 : 0);
    inside += dut.accepted_i;
    inside -= dut.taken_i;
    set(dut.k_leaves_i, in(1));
    set(dut.k_holds_i, dut.k_leaves_i | in(1));
    set(dut.f_accepts_i, dut.k_leaves_i | in(1));
    set(dut.t_waits_for_slots_i, in(1));
    set(dut.inc_conflicts_i, in(1));
    set(dut.inc_words_i, in(3));
    set(dut.inc_taps_i, in(12));
    set(dut.inc_lines_i, in(1));
    set(dut.inc_palette_i, in(4));
    set(dut.inc_multiplies_address_i, in(10));
    set(dut.inc_multiplies_filter_i, in(255));
    set(dut.inc_multiplies_eval_i, in(56));
    set(dut.inc_multiplies_combine_i, in(6));
    set(dut.inc_multiplies_effects_i, in(7));
    set(dut.looked_i, in(1));
    set(dut.hits_i, in(4095));
    set(dut.misses_i, in(4095) & ~unsigned{dut.hits_i});
    set(dut.duplicates_i, dut.misses_i & in(4095));
    set(dut.color_i, in(7));
    set(dut.draw_i, in(3));
    dut.eval();
    edge();
  }
  std::array<std::uint64_t, kLimitCounters> out{};
  for (unsigned n = 0; n < kLimitCounters; ++n) {
    set(dut.number_i, n);
    dut.eval();
    out[n] = dut.value_o;
  }
  dut.final();
  return out;
}

/// Every counter that starts shortly before 2^32 or 2^64 counts as one that starts at 0, modulo
/// 2^64; what is wrong, or nothing.
template <class Dut>
std::string check_counter_limits() {
  const auto plain = count_from<Dut>(0);
  for (const std::uint64_t start : {(std::uint64_t{1} << 32) - 20, ~std::uint64_t{0} - 19}) {
    const auto moved = count_from<Dut>(start);
    for (unsigned n = 0; n < kLimitCounters; ++n) {
      if (plain[n] < 40) return "counter " + std::to_string(n) + " hardly moves";
      if (moved[n] != plain[n] + start) {
        return "counter " + std::to_string(n) + " from " + std::to_string(start) + " comes to " +
               std::to_string(moved[n]) + ", expected " + std::to_string(plain[n] + start);
      }
    }
  }
  return "";
}

}  // namespace ptm::tests
