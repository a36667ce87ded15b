#pragma once
// The Verilated class behind RtlUnit; included by one generated file a variant.
#include <verilated.h>

#include <set>
#include <string>
#include <vector>

#include "model/reference/unit/register_map.h"
#include "testbench/rtl/initial_values.h"
#include "testbench/rtl/pending_lines.h"
#include "testbench/rtl/unit_probe.h"
#include "testbench/rtl/verilated_unit.h"

namespace ptm::testbench {

/// Dut is what Verilator made of testbench/sv/ptm_unit_tb.sv.
///
/// A clock cycle is one evaluation, the edge at its end. Frames read the outputs before they drive
/// the cycle's inputs: no output of the streams depends on an input of the same cycle.
///
/// Asserting says that the RTL's assertions are built in: they sample what stood before the
/// evaluation, so what depends on the inputs must have settled by then.
template <class Dut, bool Asserting>
class VerilatedUnit final : public RtlUnit {
 public:
  explicit VerilatedUnit(std::string_view name) : name_(name) {}
  ~VerilatedUnit() override { dut_.final(); }

  [[nodiscard]] std::string_view name() const override { return name_; }

  void load(const reference::UnitState& state) override {
    memory_ = state.memory;
    base_ = state.base;
    failed_ = state.failed;
    writes_ = register_writes(state);
    start();
    const std::uint32_t status = read(kStatus);
    if (status != 0) {
      throw RtlUnitRefusal(
          "rtl unit " + name_ + ": a draw is illegal, status " + std::to_string(status), status);
    }
  }

  pipeline::UnitFrameResult run(const pipeline::UnitFrame& frame, pipeline::MemoryTiming& memory,
                                const pipeline::StreamTiming& timing,
                                const std::optional<pipeline::MemoryFault>& fault) override {
    if (broken_) start();
    memory.reset();
    pending_.clear();
    write(kCommand, frame.keep_cache ? 2 : 3);
    pipeline::UnitFrameResult result;
    result.taken.reserve(frame.fragments.size());
    result.pixels.reserve(frame.fragments.size());
    broken_ = true;  // until the end is reached
    stream(frame, memory, timing, fault, result);
    if (!result.fault) {
      expect_silence();
      broken_ = false;
    }
    result.counters = counters();
    return result;
  }

  void stall_requests(double probability, std::uint64_t seed) override {
    request_stall_ = {.seed = seed, .output_stall = probability};
  }

  RtlUnitSeen cycle(const RtlUnitPins& pins) override {
    pins_.frag_valid_i = pins.valid;
    drive(pins.fragment);
    pins_.pix_ready_i = pins.pixel_ready;
    pins_.mem_req_ready_i = pins.request_ready;
    pins_.mem_rsp_valid_i = pins.response;
    pins_.mem_rsp_tag_i = pins.tag;
    drive(pins.line);
    pins_.mem_rsp_error_i = pins.failed;
    if (pins.write) {
      pins_.reg_we_i = 1;
      pins_.reg_addr_i = pins.write->address;
      pins_.reg_wdata_i = pins.write->data;
    }
    dut_.eval();  // outputs may depend on inputs here
    const RtlUnitSeen now = seen();
    clock_edge();
    pins_.reg_we_i = 0;
    return now;
  }

  [[nodiscard]] RtlUnitSeen seen() const override {
    return {pins_.frag_ready_o != 0,
            pins_.pix_valid_o != 0,
            pixel(),
            pins_.mem_req_valid_o != 0,
            pins_.mem_req_line_o,
            pins_.mem_req_tag_o,
            pins_.irq_o != 0};
  }

  void reset(bool memory_too) override {
    pins_.frag_valid_i = 0;
    pins_.pix_ready_i = 0;
    pins_.mem_req_ready_i = 1;
    pins_.mem_rsp_valid_i = 0;
    pins_.reg_we_i = 0;
    pins_.probe_i = unit_probe::kNone;
    dut_.rst_ni = 1;  // so that the next lines are an edge
    dut_.mem_rst_ni = 1;
    dut_.eval();
    dut_.rst_ni = 0;
    dut_.mem_rst_ni = !memory_too;
    dut_.eval();  // it falls between two edges: a request that was offered is not taken at the next
    clock_edge();
    dut_.mem_rst_ni = 1;
    dut_.rst_ni = 1;
    dut_.eval();
  }

  void write(std::uint16_t address, std::uint32_t data) override {
    pins_.frag_valid_i = 0;
    pins_.pix_ready_i = 0;
    pins_.mem_rsp_valid_i = 0;
    pins_.reg_we_i = 1;
    pins_.reg_addr_i = address;
    pins_.reg_wdata_i = data;
    clock_edge();
    pins_.reg_we_i = 0;
    pins_.reg_addr_i = kNoRegister;  // reading is combinational: the least is simulated there
  }

  [[nodiscard]] std::uint32_t read(std::uint16_t address) override {
    pins_.reg_addr_i = address;
    dut_.eval();
    return pins_.reg_rdata_o;
  }

  [[nodiscard]] reference::UnitCounters counters() override {
    reference::UnitCounters counters;
    for (unsigned n = 0; n < reference::kUnitCounters; ++n) {
      const unsigned low = reference::registers::kCounters + 2 * n;
      counters.value[n] = read(static_cast<std::uint16_t>(low)) |
                          std::uint64_t{read(static_cast<std::uint16_t>(low + 1))} << 32;
    }
    return counters;
  }

  [[nodiscard]] std::uint32_t probe(std::uint8_t number) override {
    pins_.probe_i = number;
    dut_.eval();
    const std::uint32_t value = pins_.probe_o;
    pins_.probe_i = unit_probe::kNone;
    return value;
  }

 private:
  using Cycle = pipeline::Cycle;
  static constexpr std::uint16_t kCommand = reference::registers::kCommand,
                                 kStatus = reference::registers::kErrors,
                                 kState = reference::registers::kState, kNoRegister = 0x0fff;
  static constexpr unsigned kDrain = 16;         ///< cycles watched for a pixel too many
  static constexpr unsigned kCheckCycles = 256;  ///< far more than four draws' check takes

  void clock_edge() {
    if constexpr (Asserting) dut_.eval();
    pins_.clk_i = !pins_.clk_i;
    dut_.eval();
  }

  /// Reset and registers.
  void start() {
    reset(true);
    for (const reference::RegisterWrite& w : writes_) write(w.address, w.data);
    unsigned waited = 0;
    while ((read(kState) & 1U) != 0) {
      if (++waited > kCheckCycles) fail("the check of the draws does not end", waited);
      clock_edge();
    }
    broken_ = false;
  }

  [[noreturn]] void fail(const std::string& what, Cycle cycle) const {
    throw RtlProtocolError("rtl unit " + name_ + ": " + what + " in cycle " +
                           std::to_string(cycle));
  }

  void drive(const reference::UnitFragment& f) {
    pins_.frag_x_i = f.x;
    pins_.frag_y_i = f.y;
    pins_.frag_u_i = static_cast<IData>(f.u);
    pins_.frag_v_i = static_cast<IData>(f.v);
    pins_.frag_lod_i = f.lod;
    pins_.frag_axis_u_i = static_cast<IData>(f.axis_u);
    pins_.frag_axis_v_i = static_cast<IData>(f.axis_v);
    pins_.frag_probes_log2_i = f.probes_log2;
    pins_.frag_lu_i = static_cast<IData>(f.lu);
    pins_.frag_lv_i = static_cast<IData>(f.lv);
    pins_.frag_hu_i = static_cast<IData>(f.hu);
    pins_.frag_hv_i = static_cast<IData>(f.hv);
    pins_.frag_lit_i = f.lit;
    pins_.frag_draw_i = f.draw;
  }
  void drive(const reference::Line& line) {
    for (unsigned w = 0; w < reference::kLineWords; ++w) pins_.mem_rsp_line_i[w] = line[w];
  }
  [[nodiscard]] reference::UnitPixel pixel() const {
    const std::uint32_t rgba = pins_.pix_rgba_o;
    return {pins_.pix_x_o,
            pins_.pix_y_o,
            {static_cast<std::uint8_t>(rgba), static_cast<std::uint8_t>(rgba >> 8),
             static_cast<std::uint8_t>(rgba >> 16)},
            static_cast<std::uint8_t>(rgba >> 24),
            pins_.pix_lum_saturated_o != 0,
            pins_.pix_color_saturated_o != 0,
            pins_.pix_mem_error_o != 0};
  }

  /// The one loop of all frames.
  void stream(const pipeline::UnitFrame& frame, pipeline::MemoryTiming& memory,
              const pipeline::StreamTiming& timing,
              const std::optional<pipeline::MemoryFault>& fault,
              pipeline::UnitFrameResult& result) {
    const std::size_t count = frame.fragments.size();
    std::size_t accepted = 0, taken = 0;
    Cycle offer_at = pipeline::gap(timing, 0), last_transfer = 0;
    for (Cycle cycle = 0; taken < count; ++cycle) {
      const bool offered = accepted < count && cycle >= offer_at;
      if (offered && cycle == offer_at) drive(frame.fragments[accepted]);
      const bool ready = !pipeline::stalled(timing, cycle);
      pins_.frag_valid_i = offered;
      pins_.pix_ready_i = ready;
      bool moved = false, wrong_tag = false;
      if (offered && pins_.frag_ready_o) {
        offer_at = cycle + 1 + pipeline::gap(timing, ++accepted);
        moved = true;
      }
      if (ready && pins_.pix_valid_o) {
        if (taken == accepted) fail("a pixel before its fragment", cycle);
        result.pixels.push_back(pixel());
        result.taken.push_back(cycle);
        ++taken;
        moved = true;
      }
      const bool asks = pins_.mem_req_valid_o && !pipeline::stalled(request_stall_, cycle);
      pins_.mem_req_ready_i = pins_.mem_req_valid_o ? asks : 1;
      if (asks) {
        ask(memory, fault, cycle, result);
        moved = true;
      }
      const bool answers = pending_.due(cycle);
      pins_.mem_rsp_valid_i = answers;
      if (answers) {
        wrong_tag = answer(fault);
        moved = true;
      }
      if (moved) last_transfer = cycle;
      clock_edge();
      if (wrong_tag && (read(kState) & 2U) != 0) {
        result.fault = {"cycle " + std::to_string(cycle) + ": the memory answered with tag " +
                            std::to_string(read(kState) >> 8 & 255U) +
                            ", which is not outstanding" + waiting(),
                        cycle};
        return;
      }
      if (cycle >= last_transfer + pipeline::kPatience) {
        result.fault = {"cycle " + std::to_string(cycle) + ": no transfer for " +
                            std::to_string(pipeline::kPatience) + " cycles" + waiting(),
                        cycle};
        return;
      }
    }
  }

  /// A request is transferred.
  void ask(pipeline::MemoryTiming& memory, const std::optional<pipeline::MemoryFault>& fault,
           Cycle cycle, pipeline::UnitFrameResult& result) {
    const std::uint64_t index = result.answered.size();
    const std::uint32_t outer = pins_.mem_req_line_o;
    const std::uint32_t line = (outer - base_) & reference::kOuterMask;
    if (line >= memory_.size()) fail("line " + std::to_string(outer) + " read", cycle);
    Cycle done = memory.line(index, outer, cycle);
    if (fault && fault->index == index && fault->kind == pipeline::MemoryFault::Kind::never) {
      done = pipeline::kNever;
    }
    result.answered.push_back(done);
    if (done != pipeline::kNever) pending_.add({done, index, line, pins_.mem_req_tag_o});
  }

  /// Drives the response that is due; true if its tag is made wrong.
  bool answer(const std::optional<pipeline::MemoryFault>& fault) {
    const PendingLines::Answer due = pending_.take();
    drive(memory_[due.line]);
    pins_.mem_rsp_error_i = failed_.contains(due.line);
    pins_.mem_rsp_tag_i = due.tag;
    if (!fault || fault->index != due.index) return false;
    unsigned other = due.tag;
    do {
      other = (other + 1) & 255U;
    } while (other != due.tag && pending_.outstanding(static_cast<std::uint8_t>(other)));
    pins_.mem_rsp_tag_i = static_cast<CData>(other);
    return true;
  }

  /// Who waits for what.
  [[nodiscard]] std::string waiting() {
    if (probe(unit_probe::kHolds) == 0) return "; no fragment waits at K";
    return "; the fragment at (" + std::to_string(probe(unit_probe::kX)) + ", " +
           std::to_string(probe(unit_probe::kY)) + ") waits at K for line " +
           std::to_string(probe(unit_probe::kLine)) + ", tag " +
           std::to_string(probe(unit_probe::kSlot));
  }

  /// All pixels are out: no more may come.
  void expect_silence() {
    pins_.frag_valid_i = 0;
    pins_.mem_rsp_valid_i = 0;
    pins_.pix_ready_i = 1;
    for (unsigned n = 0; n < kDrain; ++n) {
      if (pins_.pix_valid_o) fail("a pixel too many", n);
      clock_edge();
    }
    if ((read(kState) & 1U) != 0) fail("the unit stays busy", kDrain);
  }

  std::string name_;
  std::vector<reference::Line> memory_;
  std::uint32_t base_ = 0;          ///< the outer memory's line that is memory_[0]
  std::set<std::uint32_t> failed_;  ///< lines of it that cannot be read
  std::vector<reference::RegisterWrite> writes_;
  PendingLines pending_;
  pipeline::StreamTiming request_stall_;
  bool broken_ = false;
  VerilatedContext context_;
  Dut dut_{with_initial_values(context_)};
  /// The pins where Verilator keeps them; the class itself reaches each through a reference.
  decltype(*Dut::rootp)& pins_ = *dut_.rootp;
};

}  // namespace ptm::testbench
