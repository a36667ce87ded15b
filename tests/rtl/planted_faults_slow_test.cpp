// Tests of the tests: faults planted in a copy of the RTL, one at a time, and the test that notices
// each. What a test of the whole unit drives is recorded from the right unit and replayed on the
// wrong one (four_state.h), whose registers are 0 at first, so that no X gives it away.
#include <deque>

#include "tests/rtl/fault.h"
#include "tests/rtl/four_state.h"
#include "tests/rtl/pin_frame.h"

namespace ptm::tests {
namespace {

testbench::RtlUnitVariant small_unit() { return testbench::rtl_unit_variants().back(); }

/// What RtlUnitReset and RtlUnitDrain do: resets in the middle of frames, whole frames after them
/// with late answers, and draws that were forgotten.
std::string reset_recording() {
  const auto verilated = small_unit().make();
  UnitRecording unit(*verilated);
  const SmallWorld world = make_reset_world(small_unit());
  const auto memory = make_memory(pipeline::RandomMemory{.seed = 4, .latency_max = 30});
  unit.load(world.state);
  for (pipeline::Cycle moment = 6; moment < 90; moment += 4) {
    const PinFrame broken =
        run_pins(unit, world.state, world.fragments, *memory, LateAnswers{}, moment);
    unit.reset(false);
    unit.read(0x1002);
    unit.read(0x1003);
    write_registers(unit, world.state);
    const auto whole = std::span(world.fragments).first(moment % 8 == 2 ? 4 : 12);
    (void)run_pins(unit, world.state, whole, *memory, LateAnswers{broken.owed, 3, 2}, 100'000);
    for (std::uint16_t n = 0; n < 2 * reference::kUnitCounters; ++n) {
      unit.read(static_cast<std::uint16_t>(0x2000 + n));
    }
    unit.read(0x1003);
  }
  const auto wait = [&unit] {
    for (int n = 0; n < 30; ++n) unit.write(0x1000, 0);
  };
  (void)run_pins(unit, world.state, world.fragments, *memory, LateAnswers{}, 20);
  unit.reset(true);
  wait();
  unit.read(0x1003);
  unit.write(0, 7);
  wait();
  unit.read(0x1002);
  unit.reset(true);
  unit.read(0x1002);
  unit.write(0x1001, 1000);
  unit.write(0, 1);
  wait();
  unit.read(0x1002);
  unit.write(0x1009, 31);
  unit.read(0x1008);
  unit.reset(true);
  for (const int address : {0x1001, 0x1008, 0x1009}) {
    unit.read(static_cast<std::uint16_t>(address));
  }
  return unit.text();
}

/// What RtlUnitPort and RtlUnitRegisters do, as far as it can be replayed: everything read back,
/// events with and without the interrupt, writes that come while fragments are inside.
std::string register_recording() {
  const auto verilated = small_unit().make();
  UnitRecording unit(*verilated);
  const SmallWorld world = make_reset_world(small_unit());
  unit.load(world.state);
  unit.read_registers();
  // A draw's error is found while its event is cleared.
  const auto illegal = [&unit](int clears_after) {
    unit.write(192, 7);
    for (int cycle = 1; cycle < 30; ++cycle) {
      unit.write(cycle == clears_after ? 0x1008 : 0x1000, cycle == clears_after ? 31 : 0);
      unit.read(0x1008);
    }
  };
  for (const int cycle : {26, 27, 28}) illegal(cycle);
  unit.load(world.state);
  (void)unit.frame(world.state, world.fragments, 2);
  unit.write(0x1008, 31);
  // The last pixel inside is taken in the cycle in which another fragment is accepted: no end of a
  // frame.
  testbench::RtlUnitPins pins{.valid = true, .fragment = world.fragments.back()};
  pins.pixel_ready = false;
  std::deque<testbench::RtlUnitSeen> asked;
  testbench::RtlUnitSeen seen;
  for (int cycle = 0; cycle < 500 && !seen.pixel_valid; ++cycle) {
    pins.response = !asked.empty();
    if (pins.response) {
      pins.tag = asked.front().tag;
      pins.line = world.state.memory.at(asked.front().line - world.state.base);
      asked.pop_front();
    }
    seen = unit.cycle(pins);
    if (seen.ready) pins.valid = false;
    if (seen.request) asked.push_back(seen);
  }
  pins.response = false;
  pins.valid = true;
  pins.pixel_ready = true;
  seen = unit.cycle(pins);
  EXPECT_TRUE(seen.ready && seen.pixel_valid);
  unit.read(0x1008);
  pins.pixel_ready = false;
  for (const int address : {0x0, 0x1001, 0x1009}) {
    unit.write(static_cast<std::uint16_t>(address), 0);
  }
  unit.read_registers();
  pins.valid = false;
  for (int cycle = 0; cycle < 4; ++cycle) (void)unit.cycle(pins);
  return unit.text();
}

class PlantedRegister : public testing::TestWithParam<Fault> {};

TEST_P(PlantedRegister, IsNoticedByTheTestsOfRegisters) {
  const Fault& fault = GetParam();
  static const std::string recording = register_recording();
  const ChangedRtl changed(fault.file, fault.from, fault.to, unit_sources());
  const FourStateUnit unit(small_unit(), changed.files(), FourStateUnit::Start::zero);
  const ToolRun run = unit.replay(recording);
  EXPECT_EQ(run.output.find("replayed"), std::string::npos) << "nobody noticed";
  EXPECT_NE(run.output.find("differs"), std::string::npos) << run.output;
}

INSTANTIATE_TEST_SUITE_P(
    Faults, PlantedRegister,
    testing::Values(Fault{"ClearBeatsSet", "rtl/registers/ptm_registers_events.sv",
                          "events_q <= kept | causes_i;",
                          "events_q <= we_events_i ? kept : events_q | causes_i;"},
                    Fault{"NothingClears", "rtl/registers/ptm_registers_events.sv",
                          "events_q & ~wdata_i", "events_q"},
                    Fault{"EnableIgnored", "rtl/registers/ptm_registers_events.sv",
                          "(events_q & enable_q) != '0", "events_q != '0"},
                    Fault{"IdleWhileOneEnters", "rtl/front/ptm_front_inside.sv",
                          "taken_i && !accepted_i && inside_q == 16'd1",
                          "taken_i && inside_q == 16'd1"},
                    Fault{"WrittenUnderFragments", "rtl/registers/ptm_registers.sv",
                          "assign locked          = busy_i || accepted_i;",
                          "assign locked = 1'b0;"},
                    Fault{"ReadBackOfTheWrongDraw", "rtl/registers/ptm_registers_draw_word.sv",
                          "if (addr_i[7:6] == 2'(d)) begin", "if (addr_i[7:6] == 2'(d ^ 1)) begin"},
                    Fault{"CapabilityMisplaced", "rtl/registers/ptm_registers.sv",
                          "reg_rdata_o = capabilities_i[32*n +: 32];",
                          "reg_rdata_o = {capabilities_i[32*n +: 31], 1'b0};"}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(PlantedRegisters, AreNoticedBecauseTheRightUnitReplays) {
  const FourStateUnit unit(small_unit(), unit_sources(), FourStateUnit::Start::zero);
  const ToolRun run = unit.replay(register_recording());
  EXPECT_NE(run.output.find("replayed"), std::string::npos) << run.output;
}

class PlantedReset : public testing::TestWithParam<Fault> {};

TEST_P(PlantedReset, IsNoticedByTheTestsOfResets) {
  const Fault& fault = GetParam();
  static const std::string recording = reset_recording();
  const ChangedRtl changed = fault.planted_in(unit_sources());
  const FourStateUnit unit(small_unit(), changed.files(), FourStateUnit::Start::zero);
  const ToolRun run = unit.replay(recording);
  EXPECT_EQ(run.output.find("replayed"), std::string::npos) << "nobody noticed";
  EXPECT_NE(run.output.find("differs"), std::string::npos) << run.output;
}

INSTANTIATE_TEST_SUITE_P(
    Faults, PlantedReset,
    testing::Values(
        Fault{"Outstanding", "rtl/front/ptm_front_miss_ring.sv", "outstanding_q <= '0;",
              "outstanding_q <= outstanding_q;"},
        Fault{"LineWritten", "rtl/front/ptm_front_miss_bank.sv", "written_q <= '0;",
              "written_q <= written_q;"},
        Fault{"LineRead", "rtl/front/ptm_front_miss_bank.sv", "valid_q   <= 1'b0;",
              "valid_q <= valid_q;"},
        Fault{"LineRow", "rtl/front/ptm_front_miss_bank.sv", "row_q     <= '0;", "row_q <= row_q;"},
        Fault{"FragmentFifoCount", "rtl/memory/ptm_memory_fifo.sv", "count_q    <= '0;",
              "count_q <= count_q;"},
        Fault{"TagsValid", "rtl/front/ptm_front_tag_bank.sv", "if (!rst_ni) valid_q <= '0;",
              "if (!rst_ni) valid_q <= valid_q;"},
        Fault{"SubBeat", "rtl/front/ptm_front_split.sv", "if (!rst_ni) sub_q <= '0;",
              "if (!rst_ni) sub_q <= sub_q;"},
        Fault{"Probe", "rtl/front/ptm_front_beats.sv", "probe_q  <= '0;", "probe_q <= probe_q;"},
        Fault{"Footprint", "rtl/front/ptm_front_beats.sv", "second_q <= 1'b0;",
              "second_q <= second_q;"},
        Fault{"Group", "rtl/front/ptm_front_beats.sv", "group_q  <= '0;", "group_q <= group_q;"},
        Fault{"Inside", "rtl/front/ptm_front_inside.sv", "if (!rst_ni) inside_q <= '0;",
              "if (!rst_ni) inside_q <= inside_q;"},
        Fault{"Draws", "rtl/registers/ptm_registers.sv", "if (!rst_ni) draws_q <= '0;",
              "if (!rst_ni) draws_q <= draws_q;"},
        Fault{"Errors", "rtl/registers/ptm_registers.sv", "errors_q  <= '0;",
              "errors_q <= errors_q;"},
        Fault{"Events", "rtl/registers/ptm_registers_events.sv", "events_q <= '0;",
              "events_q <= events_q;"},
        Fault{"Enable", "rtl/registers/ptm_registers_events.sv", "enable_q <= '0;",
              "enable_q <= enable_q;"},
        Fault{"MemoryLines", "rtl/registers/ptm_registers.sv", "memory_lines_q <= '0;",
              "memory_lines_q <= memory_lines_q;"},
        Fault{"DrainSkipped", "rtl/front/ptm_front_miss_ring.sv",
              "if (!rst_ni) draining_q <= 1'b1;", "if (!rst_ni) draining_q <= 1'b0;"},
        Fault{"DrainTooShort", "rtl/front/ptm_front_miss_ring.sv",
              "else if (owed_q == '0) draining_q", "else if (owed_q <= 1) draining_q"},
        Fault{"OwedForgotten", "rtl/front/ptm_front_miss_ring.sv",
              "negedge mem_rst_ni) begin\n    if (!mem_rst_ni) owed_q",
              "negedge rst_ni) begin\n    if (!rst_ni) owed_q"},
        Fault{"OwedKept", "rtl/front/ptm_front_miss_ring.sv", "if (!mem_rst_ni) owed_q <= '0;",
              "if (!mem_rst_ni) owed_q <= owed_q;"}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(PlantedResets, AreNoticedBecauseTheRightUnitReplays) {
  const FourStateUnit unit(small_unit(), unit_sources(), FourStateUnit::Start::zero);
  const ToolRun run = unit.replay(reset_recording());
  EXPECT_NE(run.output.find("replayed"), std::string::npos) << run.output;
}

class PlantedX : public testing::TestWithParam<Fault> {};

TEST_P(PlantedX, IsNoticedByTheFourStateScenes) {
  const Fault& fault = GetParam();
  const ChangedRtl changed = fault.planted_in(unit_sources());
  const FourStateUnit unit(small_unit(), changed.files());
  bool noticed = false;
  for (const SmallScene& scene : small_scenes()) {
    const SmallWorld world = make_small_world(scene, small_unit(), 12);
    const auto verilated = small_unit().make();
    UnitRecording recording(*verilated);
    recording.load(world.state);
    (void)recording.frame(world.state, world.fragments, 1);
    noticed = noticed || unit.replay(recording.text()).output.find("xx") != std::string::npos;
    if (noticed) break;
  }
  EXPECT_TRUE(noticed);
}

INSTANTIATE_TEST_SUITE_P(
    Faults, PlantedX,
    testing::Values(Fault{"ColorThatWasNeverLoaded", "rtl/filter/ptm_filter_fields.sv",
                          "assign replace     = !l3_color_i;", "assign replace     = 1'b0;"},
                    Fault{"TapThatWasNeverFetched", "rtl/filter/ptm_filter_tap_word.sv",
                          "if (!rst_ni) q_q <= '0;", "if (!rst_ni) q_q <= q_q;"},
                    Fault{"EntryThatWasNeverLookedUp", "rtl/filter/ptm_filter_tap_hold.sv",
                          "if (!rst_ni) hold_q <= '0;", "if (!rst_ni) hold_q <= hold_q;"}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ptm::tests
