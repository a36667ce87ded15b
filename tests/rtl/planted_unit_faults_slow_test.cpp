// Tests of the tests: faults planted in a copy of the RTL, one at a time, of which the whole unit's
// tests tell. What such a test drives is recorded from the right unit, pin by pin, and replayed on
// the wrong one (four_state.h). docs/verification/plan.md, Planted faults.
#include <functional>

#include "model/reference/unit/register_map.h"
#include "tests/rtl/draw_check_drive.h"
#include "tests/rtl/fault.h"
#include "tests/rtl/four_state.h"
#include "tests/rtl/half_vector_world.h"
#include "tests/rtl/wide_texture.h"

namespace ptm::tests {
namespace {

namespace registers = reference::registers;

testbench::RtlUnitVariant small_unit() { return testbench::rtl_unit_variants().back(); }
testbench::RtlUnitVariant small_unit_with_effects() {
  const auto variants = testbench::rtl_unit_variants();
  return variants[variants.size() - 2];
}

/// What was driven and seen, and of which unit.
struct Recording {
  testbench::RtlUnitVariant variant;
  std::string text;
};

Recording recorded(const testbench::RtlUnitVariant& variant, const reference::UnitState& state,
                   const std::function<void(UnitRecording&)>& drive) {
  const auto verilated = variant.make();
  UnitRecording recording(*verilated);
  recording.load(state);
  drive(recording);
  for (std::uint16_t n = 0; n < 2 * reference::kUnitCounters; ++n) {
    recording.read(static_cast<std::uint16_t>(0x2000 + n));
  }
  for (const auto address : {registers::kErrors, registers::kState, registers::kEvents}) {
    recording.read(address);
  }
  return {variant, recording.text()};
}

/// What RtlUnitMemory, RtlUnitFailedLines and RtlUnitBase drive: answers in the cycle of their
/// request, lines that cannot be read, a base that is not 0.
Recording memory_recording() {
  SmallWorld world = make_reset_world(small_unit());
  world.state.base = 0x2000001;
  for (std::uint32_t line = 0; line < world.state.memory.size(); line += 5) {
    world.state.failed.insert(line);
  }
  return recorded(small_unit(), world.state, [&world](UnitRecording& unit) {
    (void)drive_frame(unit, world.state, world.fragments, 12,
                      {.seed = 3, .stalls = true, .answers_at_once = true});
  });
}

/// What RtlUnitStrayAnswers drives.
Recording stray_recording() {
  const SmallWorld world = make_reset_world(small_unit());
  return recorded(small_unit(), world.state, [&world](UnitRecording& unit) {
    (void)drive_frame(unit, world.state, world.fragments, 12,
                      {.seed = 4, .stalls = true, .latency_max = 60, .strays = true});
  });
}

/// What RtlUnitDrawCheck and RtlUnitRewrite drive.
Recording check_recording() {
  const SmallScene scene{.name = "Checked", .combine = reference::Combine::modulate, .draws = 4};
  const SmallWorld world = make_small_world(scene, small_unit(), 6);
  return recorded(small_unit(), world.state, [&world](UnitRecording& unit) {
    const DrawWrites writes(world.state, 1);
    const reference::RegisterWrite bad{writes.control.address, writes.control.data | 7U};
    for (const std::uint64_t apart : {1U, 2U, 9U, 27U, 28U}) {
      (void)drive_rewrite(unit, world.state, world.fragments, 12,
                          {.apart = apart, .first = writes.control, .second = bad}, 80);
      unit.read(registers::kErrors);
      (void)drive_rewrite(unit, world.state, world.fragments, 12,
                          {.apart = apart, .first = bad, .second = writes.control}, 2000);
      unit.read(registers::kErrors);
    }
  });
}

/// What RtlUnitHalfVectors drives.
Recording blocked_recording() {
  const testbench::RtlUnitVariant variant = small_unit_with_effects();
  const SmallWorld world = make_half_vector_world(variant, 90);
  return recorded(variant, world.state, [&](UnitRecording& unit) {
    (void)drive_frame(unit, world.state, world.fragments, 16, half_vector_drive(variant));
  });
}

/// What RtlUnitWideTexture drives, of a texture that is wide alone.
Recording wide_recording() {
  const WideTexture texture{.width = 4096, .height = 16};
  const reference::UnitState state = wide_state(texture);
  const auto fragments = wide_fragments(texture, 120);
  return recorded(small_unit(), state, [&](UnitRecording& unit) {
    (void)drive_frame(unit, state, fragments, 12, {.latency_max = 4});
  });
}

std::string replayed(const Recording& recording, const std::vector<std::string>& sources) {
  const FourStateUnit unit(recording.variant, sources, FourStateUnit::Start::zero);
  return unit.replay(recording.text).output;
}

struct UnitFault {
  Fault fault;
  Recording (*record)();
};

class PlantedUnitFault : public testing::TestWithParam<UnitFault> {};

TEST_P(PlantedUnitFault, IsNoticedByWhatTheUnitsTestsDrive) {
  const ChangedRtl changed = GetParam().fault.planted_in(unit_sources());
  const std::string said = replayed(GetParam().record(), changed.files());
  EXPECT_EQ(said.find("replayed"), std::string::npos) << "nobody noticed";
  EXPECT_NE(said.find("differs"), std::string::npos) << said;
}

INSTANTIATE_TEST_SUITE_P(
    Memory, PlantedUnitFault,
    testing::Values(UnitFault{{"AnswerInItsRequestsCycleDropped",
                               "rtl/front/ptm_front_miss_ring.sv",
                               "(request && response_slot == request_q)", "1'b0"},
                              memory_recording},
                    UnitFault{{"ErrorBitOfAnAnswerLost", "rtl/front/ptm_front_miss_ring.sv",
                               ".write_failed_i(rsp_failed_i)", ".write_failed_i(1'b0)"},
                              memory_recording},
                    UnitFault{{"BaseAddressLeftOut", "rtl/front/ptm_front.sv",
                               "= req_line + mem_base_i;", "= req_line;"},
                              memory_recording},
                    UnitFault{{"TagsRangeUnchecked", "rtl/front/ptm_front_miss_ring.sv",
                               "9'(rsp_tag_i) < 9'(Slots) &&", ""},
                              stray_recording},
                    UnitFault{{"TagsAnsweredTwice", "rtl/front/ptm_front_miss_ring.sv",
                               "if (response) outstanding_q[response_slot] <= 1'b0;", ""},
                              stray_recording}),
    [](const auto& tested) { return std::string(tested.param.fault.name); });

constexpr const char* kOpen = "assign open         = !error && !checking;";
constexpr const char* kWaits = "if (we_control[d]) waiting_q[d] <= 1'b1;";

INSTANTIATE_TEST_SUITE_P(
    Checks, PlantedUnitFault,
    testing::Values(
        UnitFault{{"AcceptsDuringACheck", "rtl/ptm_unit.sv", kOpen, "assign open = !error;"},
                  check_recording},
        UnitFault{{"AcceptsAnIllegalDraw", "rtl/ptm_unit.sv", kOpen, "assign open = !checking;"},
                  check_recording},
        UnitFault{{"RewriteInTheStartingCycleLost", "rtl/registers/ptm_registers.sv", kWaits,
                   "if (we_control[d] && !(start && next == 2'(d))) waiting_q[d] <= 1'b1;"},
                  check_recording},
        UnitFault{{"RewriteDuringACheckLost", "rtl/registers/ptm_registers.sv", kWaits,
                   "if (we_control[d] && !(active_q && check_draw_q == 2'(d))) "
                   "waiting_q[d] <= 1'b1;"},
                  check_recording}),
    [](const auto& tested) { return std::string(tested.param.fault.name); });

INSTANTIATE_TEST_SUITE_P(
    Fifos, PlantedUnitFault,
    testing::Values(UnitFault{{"HalfVectorsFifoOneTooShallow", "rtl/ptm_unit.sv",
                               "FragmentFifo + 14", "FragmentFifo + 13"},
                              blocked_recording},
                    UnitFault{{"FifosPlaceTooNarrow", "rtl/memory/ptm_memory_fifo.sv",
                               "localparam int PlaceBits = $clog2(Depth);",
                               "localparam int PlaceBits = $clog2(Depth) - 1;"},
                              blocked_recording}),
    [](const auto& tested) { return std::string(tested.param.fault.name); });

INSTANTIATE_TEST_SUITE_P(
    WideTextures, PlantedUnitFault,
    testing::Values(UnitFault{{"ClampLooksAtFewerBits", "rtl/front/ptm_front_wrap.sv",
                               "u_i[InBits-1:20] == '0", "u_i[24:20] == '0"},
                              wide_recording},
                    UnitFault{{"LastTexelOfFewerBits", "rtl/front/ptm_front_scale.sv",
                               "12'(side_i - 13'd1)", "{1'b0, 11'(side_i - 13'd1)}"},
                              wide_recording},
                    UnitFault{{"NextTexelComparedOnFewerBits", "rtl/front/ptm_front_scale.sv",
                               "next != signed'({1'b0, side_i})", "next[10:0] != side_i[10:0]"},
                              wide_recording},
                    UnitFault{{"PositionOfFewerBits", "rtl/front/ptm_front_scale.sv",
                               "{1'b0, rounded[31:12]}", "{2'b0, rounded[30:12]}"},
                              wide_recording}),
    [](const auto& tested) { return std::string(tested.param.fault.name); });

TEST(PlantedUnitFaults, AreNoticedBecauseTheRightUnitReplays) {
  for (const auto record :
       {memory_recording, stray_recording, check_recording, blocked_recording, wide_recording}) {
    const std::string said = replayed(record(), unit_sources());
    EXPECT_NE(said.find("replayed"), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace ptm::tests
