#pragma once
// The Verilated class behind RtlEvaluator; included by one generated file a variant.
#include <verilated.h>

#include "testbench/rtl/initial_values.h"
#include "testbench/rtl/probe.h"
#include "testbench/rtl/verilated_evaluator.h"

namespace ptm::testbench {

/// Dut is what Verilator made of testbench/sv/ptm_evaluator_tb.sv.
///
/// A clock cycle is one evaluation, the edge at its end. Streams read the outputs before they drive
/// the cycle's inputs, which saves another: no output depends on an input of the same cycle
/// (docs/spec/evaluator.md), and if one did, pixels would be lost or doubled and the run would
/// fail.
///
/// Asserting says that the RTL's assertions are built in: they sample what stood before the
/// evaluation, so what depends on the inputs must have settled by then.
template <class Dut, bool Asserting>
class VerilatedEvaluator final : public RtlEvaluator {
 public:
  explicit VerilatedEvaluator(std::string_view name) : name_(name) {}
  ~VerilatedEvaluator() override { dut_.final(); }

  [[nodiscard]] std::string_view name() const override { return name_; }

  RtlCounters stream_lrgb(std::uint64_t pixels, const pipeline::StreamTiming& timing,
                          const LrgbSource& source, const Sink& sink) override {
    pins_.rgb_map_i = 0;
    pins_.channel_i = 0;
    return stream<1>(pixels, timing, sink, [&](std::uint64_t pixel, unsigned) {
      const reference::LrgbOperands<>& in = source(pixel);
      drive(in.coef, in.bias, in.shift, in.lu, in.lv);
      drive_rgb(in.rgb);
    });
  }

  RtlCounters stream_rgb(std::uint64_t pixels, const pipeline::StreamTiming& timing,
                         const RgbSource& source, const Sink& sink) override {
    const reference::RgbOperands<>* in = nullptr;
    return stream<3>(pixels, timing, sink, [&](std::uint64_t pixel, unsigned channel) {
      if (channel == 0) in = &source(pixel);
      pins_.rgb_map_i = 1;
      pins_.channel_i = static_cast<CData>(channel);
      drive(in->coef[channel], in->bias, in->shift, in->lu, in->lv);
    });
  }

  void reset() override {
    pins_.valid_i = 0;
    pins_.ready_i = 0;
    pins_.probe_i = probe::kNone;
    dut_.rst_ni = 1;  // so that the next line is an edge
    dut_.eval();
    dut_.rst_ni = 0;
    clock_edge();
    dut_.rst_ni = 1;
    dut_.eval();
  }

  RtlSeen cycle(const RtlPins& pins) override {
    pins_.valid_i = pins.valid;
    pins_.ready_i = pins.ready;
    pins_.rgb_map_i = pins.rgb_map;
    pins_.channel_i = static_cast<CData>(pins.channel);
    pins_.sideband_i = pins.sideband;
    const reference::LrgbOperands<>& in = pins.operands;
    drive(in.coef, in.bias, in.shift, in.lu, in.lv);
    drive_rgb(in.rgb);
    dut_.eval();  // outputs may depend on inputs here
    RtlSeen seen{pins_.ready_o != 0, pins_.valid_o != 0, {}, pins_.sideband_o};
    read(seen.pixel);
    clock_edge();
    return seen;
  }

  [[nodiscard]] reference::Value probe(std::uint8_t number) override {
    pins_.probe_i = number;
    dut_.eval();
    const auto value = static_cast<reference::Value>(pins_.probe_o);
    pins_.probe_i = probe::kNone;
    return value;
  }

 private:
  using Pins = std::remove_pointer_t<decltype(Dut::rootp)>;

  /// Cycles without any transfer, though the output was ready and work was waiting, after which
  /// the RTL is said to hang: far more than its latency.
  static constexpr unsigned kPatience = 64;
  static constexpr double kOutputStallMax = 0.99;
  static constexpr unsigned kDrain = 16;  ///< cycles watched for a pixel too many

  void clock_edge() {
    if constexpr (Asserting) dut_.eval();
    pins_.clk_i = !pins_.clk_i;
    dut_.eval();
  }

  template <class Six>
  void drive(const Six& coef, const Six& bias, const Six& shift, reference::Value lu,
             reference::Value lv) {
    Pins& pins = pins_;
    for (unsigned i = 0; i < 6; ++i) {
      pins.coef_i[i] = static_cast<SData>(coef[i]);
      pins.bias_i[i] = static_cast<SData>(bias[i]);
      pins.shift_i[i] = static_cast<CData>(shift[i]);
    }
    pins.lu_i = static_cast<IData>(lu);
    pins.lv_i = static_cast<IData>(lv);
  }
  void drive_rgb(const reference::Three<reference::Value>& rgb) {
    Pins& pins = pins_;
    for (unsigned c = 0; c < 3; ++c) pins.rgb_i[c] = static_cast<SData>(rgb[c]);
  }

  /// Field by field into place: a copy in wider pieces would wait for these stores.
  void read(RtlPixel& pixel) const {
    for (unsigned c = 0; c < 3; ++c) {
      pixel.lum[c] = pins_.lum_o[c];
      pixel.out[c] = pins_.rgb_o[c];
    }
    pixel.lum_saturated = pins_.lum_saturated_o != 0;
    pixel.color_saturated = pins_.color_saturated_o != 0;
  }

  [[noreturn]] void fail(const char* what, std::uint64_t cycle, const char* item,
                         std::uint64_t number) const {
    throw RtlProtocolError("rtl " + name_ + ": " + what + " in cycle " + std::to_string(cycle) +
                           ", " + item + " " + std::to_string(number));
  }

  static void check(const pipeline::StreamTiming& timing) {
    if (!(timing.input_gap >= 0 && timing.input_gap <= 1)) {
      throw std::invalid_argument("input_gap = " + std::to_string(timing.input_gap) +
                                  ", expected 0 to 1");
    }
    if (!(timing.output_stall >= 0 && timing.output_stall <= kOutputStallMax)) {
      throw std::invalid_argument("output_stall = " + std::to_string(timing.output_stall) +
                                  ", expected 0 to 0.99");
    }
  }

  /// What StreamTiming is without gaps and stalls: the compiler drops their tests.
  struct Unhindered {
    [[nodiscard]] static std::uint64_t gap(std::uint64_t /*item*/) { return 0; }
    [[nodiscard]] static bool stalled(std::uint64_t /*cycle*/) { return false; }
  };
  struct Hindered {
    const pipeline::StreamTiming& timing;
    [[nodiscard]] std::uint64_t gap(std::uint64_t item) const {
      return pipeline::gap(timing, item);
    }
    [[nodiscard]] bool stalled(std::uint64_t cycle) const {
      return pipeline::stalled(timing, cycle);
    }
  };

  template <unsigned Beats, class DriveBeat>
  RtlCounters stream(std::uint64_t pixels, const pipeline::StreamTiming& timing, const Sink& sink,
                     const DriveBeat& drive_beat) {
    check(timing);
    if (timing.input_gap > 0 || timing.idle != 0 || timing.output_stall > 0) {
      return stream<Beats>(pixels, Hindered{timing}, sink, drive_beat);
    }
    return stream<Beats>(pixels, Unhindered{}, sink, drive_beat);
  }

  /// The one loop of all streams: Beats operands a pixel, offered and taken as `pace` says.
  /// drive_beat(pixel, channel) puts a beat on the pins when it is first offered.
  template <unsigned Beats, class Pace, class DriveBeat>
  RtlCounters stream(std::uint64_t pixels, const Pace& pace, const Sink& sink,
                     const DriveBeat& drive_beat) {
    reset();
    Pins& pins = pins_;
    RtlCounters counters;
    RtlPixel pixel;
    const std::uint64_t beats = pixels * Beats;
    std::uint64_t offer_at = pace.gap(0), first = 0, taken_at = 0, cycle = 0;
    unsigned idle = 0;  // cycles in a row that only a hanging unit explains
    for (; counters.pixels < pixels; ++cycle) {
      const bool offered = counters.beats < beats && cycle >= offer_at;
      if (offered && cycle == offer_at) {
        drive_beat(counters.beats / Beats, static_cast<unsigned>(counters.beats % Beats));
        pins.sideband_i = static_cast<IData>(counters.beats / Beats);
      }
      const bool blocked = pace.stalled(cycle);
      pins.valid_i = offered;
      pins.ready_i = !blocked;
      const bool accepted = offered && pins.ready_o;
      const bool taken = pins.valid_o && !blocked;
      if (taken) {
        if (counters.pixels * Beats + Beats > counters.beats) {
          fail("a pixel before its operands", cycle, "pixel", counters.pixels);
        }
        if (pins.sideband_o != static_cast<IData>(counters.pixels)) {
          fail("another pixel's id", cycle, "pixel", counters.pixels);
        }
        read(pixel);
        sink(counters.pixels++, pixel, cycle);
        taken_at = cycle;
      } else {
        counters.output_blocked += pins.valid_o;
      }
      if (accepted) {
        if (counters.beats == 0) first = cycle;
        offer_at = cycle + 1 + pace.gap(++counters.beats);
      } else {
        counters.input_stalled += offered;
      }
      const bool waiting = offered || counters.beats > counters.pixels * Beats;
      if (accepted || taken) {
        idle = 0;
      } else if (waiting && !blocked && ++idle > kPatience) {
        fail("the unit hangs", cycle, "waiting for pixel", counters.pixels);
      }
      clock_edge();
    }
    counters.cycles = pixels == 0 ? 0 : taken_at - first + 1;
    expect_silence(cycle, pixels);
    return counters;
  }

  /// All pixels are out: no more may come.
  void expect_silence(std::uint64_t cycle, std::uint64_t pixels) {
    pins_.valid_i = 0;
    pins_.ready_i = 1;
    for (unsigned n = 0; n < kDrain; ++n) {
      if (pins_.valid_o) fail("a pixel too many", cycle + n, "after pixel", pixels);
      clock_edge();
    }
  }

  std::string name_;
  VerilatedContext context_;
  Dut dut_{with_initial_values(context_)};
  /// The pins where Verilator keeps them; the class itself reaches each through a reference. A
  /// function that writes many copies this reference: a pin that is a byte could alias it.
  Pins& pins_ = *dut_.rootp;
};

}  // namespace ptm::testbench
