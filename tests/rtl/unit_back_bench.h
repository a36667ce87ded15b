#pragma once
#include <verilated.h>

#include <cstdint>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/reference/unit/shade.h"
#include "model/reference/unit/unit_beats.h"

/// Drives testbench/sv/ptm_unit_back_tb.sv: the registers and the back of the unit, with D and the
/// front played by the caller.
namespace ptm::tests {

/// What stands in D: one sub-beat.
struct BackBeat {
  reference::UnitFragment fragment;
  bool first_probe = false, second = false, last = false, sub_last = false;
  unsigned group = 0;
  std::array<reference::Footprint, 2> footprint{};  ///< map, colour
  std::array<unsigned, 3> taps{};                   ///< of each TMU, bit t: tap t is fetched
  std::array<std::uint32_t, 12> word{};             ///< [TMU][tap]; noise where nothing is fetched
};

/// The sub-beats of a fragment, in order.
inline std::vector<BackBeat> back_beats(const reference::UnitState& state,
                                        const reference::UnitConfig& unit,
                                        const reference::UnitFragment& fragment) {
  static std::mt19937 noise(1);
  const reference::Draw& draw = state.draws[fragment.draw];
  std::vector<BackBeat> out;
  for (const reference::Beat& whole : reference::fragment_beats(draw, fragment, unit)) {
    for (const reference::Beat& part : reference::split_beat(whole)) {
      BackBeat beat;
      beat.fragment = fragment;
      beat.first_probe = part.probe == 0;
      beat.second = part.footprint == 1;
      beat.last = part.last;
      beat.sub_last = part.sub_last;
      beat.group = static_cast<unsigned>(part.group);
      for (unsigned texture = 0; texture < 2; ++texture) {
        beat.footprint[texture] = reference::make_footprint(
            draw, fragment, static_cast<int>(texture), part.probe, part.footprint);
      }
      for (unsigned t = 0; t < reference::kTmusMax; ++t) {
        beat.taps[t] = part.tmu[t].taps;
        for (unsigned k = 0; k < reference::kTaps; ++k) {
          const reference::TexelPlace& at = part.tmu[t].tap[k].place;
          const bool fetched = (beat.taps[t] >> k & 1U) != 0;
          beat.word[4 * t + k] =
              fetched ? state.memory[at.line][at.word] : static_cast<std::uint32_t>(noise());
        }
      }
      out.push_back(beat);
    }
  }
  return out;
}

/// What happened in one cycle.
struct BackCycle {
  bool left = false;   ///< the beat left D
  bool taken = false;  ///< a pixel was taken
  bool offered = false;
  reference::UnitPixel pixel;
};

struct BackCounts {
  std::uint64_t palette = 0, filter = 0, eval = 0, combine = 0;
  bool operator==(const BackCounts&) const = default;
};

template <class Dut>
class UnitBack {
 public:
  UnitBack() { reset(); }
  ~UnitBack() { dut.final(); }
  UnitBack(const UnitBack&) = delete;
  UnitBack& operator=(const UnitBack&) = delete;

  void reset() {
    dut.reg_we_i = 0;
    dut.d_valid_i = 0;
    dut.pix_ready_i = 0;
    dut.mem_error_i = 0;
    dut.mem_failed_i = 0;
    dut.busy_i = 0;
    dut.accepted_i = 0;
    dut.last_taken_i = 0;
    dut.clk_i = 0;
    dut.rst_ni = 1;
    dut.eval();
    dut.rst_ni = 0;
    edge();
    dut.rst_ni = 1;
    dut.eval();
    counts = {};
  }

  /// A rising edge; inputs are to have been evaluated before, outputs of the cycle read.
  void edge() {
    dut.clk_i = 1;
    dut.eval();
    dut.clk_i = 0;
    dut.eval();
  }

  void write(unsigned address, std::uint32_t data) {
    dut.reg_we_i = 1;
    dut.reg_addr_i = static_cast<SData>(address);
    dut.reg_wdata_i = data;
    dut.eval();
    edge();
    dut.reg_we_i = 0;
    dut.eval();
  }
  std::uint32_t read(unsigned address) {
    dut.reg_addr_i = static_cast<SData>(address);
    dut.eval();
    return dut.reg_rdata_o;
  }
  /// Cycles until nothing is checked any more, at most 1000.
  unsigned wait_for_check() {
    unsigned cycles = 0;
    for (; dut.checking_o && cycles < 1000; ++cycles) edge();
    return cycles;
  }
  /// After a reset, which leaves palettes as they were written.
  void load_draws(const reference::UnitState& state) {
    for (const reference::RegisterWrite& w : reference::register_writes(state)) {
      if (w.address < 0x3000) write(w.address, w.data);
    }
    wait_for_check();
  }
  void load(const reference::UnitState& state) {
    for (const reference::RegisterWrite& w : reference::register_writes(state)) {
      write(w.address, w.data);
    }
    wait_for_check();
  }

  /// One cycle with this in D, or nothing.
  BackCycle cycle(const BackBeat* beat, bool ready) {
    dut.d_valid_i = beat != nullptr;
    if (beat != nullptr) drive(*beat);
    dut.pix_ready_i = ready;
    dut.eval();
    BackCycle out;
    out.left = beat != nullptr && dut.d_ready_o;
    out.offered = dut.pix_valid_o;
    out.taken = out.offered && ready;
    for (unsigned c = 0; c < 3; ++c) {
      out.pixel.rgb[c] = static_cast<std::uint8_t>(dut.pix_rgb_o >> (8 * c));
    }
    out.pixel.x = dut.pix_x_o;
    out.pixel.y = dut.pix_y_o;
    out.pixel.alpha = dut.pix_alpha_o;
    out.pixel.lum_saturated = dut.pix_lum_saturated_o != 0;
    out.pixel.color_saturated = dut.pix_color_saturated_o != 0;
    counts.palette += dut.inc_palette_o;
    counts.filter += dut.inc_filter_o;
    counts.eval += dut.inc_eval_o;
    counts.combine += dut.inc_combine_o;
    edge();
    return out;
  }

  BackCounts counts;
  Dut dut;

 private:
  void drive(const BackBeat& beat) {
    const reference::UnitFragment& f = beat.fragment;
    dut.x_i = f.x;
    dut.y_i = f.y;
    dut.lu_i = static_cast<IData>(f.lu);
    dut.lv_i = static_cast<IData>(f.lv);
    dut.lit_i = f.lit;
    dut.beat_draw_i = f.draw;
    dut.probes_log2_i = f.probes_log2;
    dut.first_probe_i = beat.first_probe;
    dut.second_i = beat.second;
    dut.group_i = static_cast<CData>(beat.group);
    for (unsigned t = 0; t < 2; ++t) {
      dut.wu_i[t] = static_cast<CData>(beat.footprint[t].wu);
      dut.wv_i[t] = static_cast<CData>(beat.footprint[t].wv);
      dut.f_i[t] = static_cast<CData>(beat.footprint[t].level_weight);
      dut.fetched_i[t] = beat.footprint[t].fetched;
    }
    dut.last_i = beat.last;
    dut.sub_last_i = beat.sub_last;
    for (unsigned t = 0; t < 3; ++t) dut.taps_i[t] = static_cast<CData>(beat.taps[t]);
    for (unsigned n = 0; n < 12; ++n) dut.word_i[n] = beat.word[n];
  }
};

}  // namespace ptm::tests
