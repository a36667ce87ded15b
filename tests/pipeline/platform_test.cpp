// The unit in someone's virtual platform: two units, one memory behind an interconnect, a
// base-protocol checker on every link.
#include <gtest/gtest.h>

#include <deque>
#include <memory>

#include "model/pipeline/unit/memory_target.h"
#include "model/pipeline/unit/shared_memory.h"
#include "model/pipeline/unit/texture_unit.h"
#include "tests/pipeline/base_protocol_checker.h"
#include "tests/pipeline/unit_plane.h"

namespace ptm::pipeline {
namespace {

using reference::UnitCounter;
using reference::UnitFragment;
using tests::BaseProtocolChecker;
using Plane = tests::UnitPlane;

const sc_core::sc_time& clock_period() {
  static const sc_core::sc_time period(1, sc_core::SC_NS);
  return period;
}

sc_core::sc_time cycles(Cycle count) {
  return sc_core::sc_time::from_value(count * clock_period().value());
}

constexpr Cycle kShortPatience = 5000;

/// A unit that draws one frame, the adapter it reaches a shared memory by, and checkers around it.
class PlatformUnit final : public sc_core::sc_module {
 public:
  TextureUnit unit;
  BaseProtocolChecker before{"before"};
  NbAdapter adapter;
  BaseProtocolChecker after{"after"};
  std::optional<UnitFrameResult> result;

  SC_HAS_PROCESS(PlatformUnit);
  PlatformUnit(const sc_core::sc_module_name& name, const reference::UnitConfig& config,
               const std::vector<reference::Draw>& draws, std::vector<UnitFragment> fragments)
      : sc_module(name),
        unit("unit", config, draws, {}, {}, clock_period()),
        adapter("adapter", cycles(kShortPatience)),
        fragments_(std::move(fragments)) {
    unit.memory.socket.bind(before.in);
    before.out.bind(adapter.in);
    adapter.out.bind(after.in);
    SC_THREAD(run);
  }

  void expect_clean() const {
    EXPECT_EQ(before.violations, std::vector<std::string>{});
    EXPECT_EQ(after.violations, std::vector<std::string>{});
    EXPECT_GT(after.transactions, 0U);
  }

 private:
  void run() {
    TextureUnit::Frame frame = unit.run({fragments_}, kShortPatience);
    const sc_core::sc_time end = cycles(frame.end);
    if (end > sc_core::sc_time_stamp()) wait(end - sc_core::sc_time_stamp());
    result = std::move(frame.result);
  }

  std::vector<UnitFragment> fragments_;
};

/// What a unit with its own memory does, bound to it directly.
UnitFrameResult alone(TextureUnit& unit, MemoryTarget& memory, const Plane& plane) {
  memory.reset();
  return unit.run({plane.fragments}, kPatience).result;
}

TEST(Platform, GivesAUnitBehindAdapterAndInterconnectTheCyclesOfOneThatHasTheMemoryToItself) {
  const Plane plane(32);
  MemoryTarget own("own", make_memory(FixedMemory{}), plane.lines, clock_period());
  TextureUnit direct("direct", plane.config, plane.draws, {}, {}, clock_period());
  BaseProtocolChecker link("link");
  direct.memory.socket.bind(link.in);
  link.out.bind(own.socket);

  MemoryTarget memory("memory", make_memory(FixedMemory{}), plane.lines, clock_period());
  BaseProtocolChecker last("last");
  Interconnect interconnect("interconnect", clock_period());
  PlatformUnit unit("unit", plane.config, plane.draws, plane.fragments);
  unit.after.out.bind(interconnect.in);
  interconnect.out.bind(last.in);
  last.out.bind(memory.socket);

  sc_core::sc_start();
  ASSERT_TRUE(unit.result);
  const UnitFrameResult want = alone(direct, own, plane);
  EXPECT_EQ(unit.result->taken, want.taken);
  EXPECT_EQ(unit.result->answered, want.answered);
  EXPECT_EQ(unit.result->counters, want.counters);
  EXPECT_GT(want.counters[UnitCounter::cycles_line_wait], 0U);
  unit.expect_clean();
  EXPECT_EQ(last.violations, std::vector<std::string>{});
  EXPECT_EQ(link.violations, std::vector<std::string>{});
  EXPECT_EQ(last.transactions, want.counters[UnitCounter::lines_read]);
  EXPECT_EQ(link.transactions, want.counters[UnitCounter::lines_read]);
}

TEST(Platform, LetsTwoUnitsShareAMemoryAndItsBandwidth) {
  const Plane plane(64);
  const FixedMemory timing{40, 4};
  MemoryTarget own("own", make_memory(timing), plane.lines, clock_period());
  TextureUnit direct("direct", plane.config, plane.draws, {}, {}, clock_period());
  direct.memory.socket.bind(own.socket);

  MemoryTarget memory("memory", make_memory(timing), plane.lines, clock_period());
  BaseProtocolChecker last("last");
  Interconnect interconnect("interconnect", clock_period());
  std::deque<PlatformUnit> units;
  for (const char* name : {"first", "second"}) {
    units.emplace_back(name, plane.config, plane.draws, plane.fragments);
    units.back().after.out.bind(interconnect.in);
  }
  interconnect.out.bind(last.in);
  last.out.bind(memory.socket);

  sc_core::sc_start();
  const UnitFrameResult want = alone(direct, own, plane);
  std::vector<Cycle> answers;
  for (const PlatformUnit& unit : units) {
    ASSERT_TRUE(unit.result);
    unit.expect_clean();
    EXPECT_EQ(unit.result->taken.size(), plane.fragments.size());
    EXPECT_EQ(unit.result->counters[UnitCounter::lines_read],
              want.counters[UnitCounter::lines_read]);
    EXPECT_GT(unit.result->taken.back(), want.taken.back()) << "alone it is faster";
    answers.insert(answers.end(), unit.result->answered.begin(), unit.result->answered.end());
  }
  EXPECT_EQ(last.violations, std::vector<std::string>{});
  std::ranges::sort(answers);
  for (std::size_t n = 1; n < answers.size(); ++n) {
    ASSERT_GE(answers[n], answers[n - 1] + timing.interval) << "more than the memory has";
  }
  // Drawing the same at the same time, they must be served in turn.
  EXPECT_LT(units[0].result->answered.front(), units[1].result->answered[1]);
  EXPECT_LT(units[1].result->answered.front(), units[0].result->answered[1]);
}

/// Answers in four phases, each by a call of its own; never if told so.
class PhasedMemory final : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket<PhasedMemory> socket{"socket"};

  SC_HAS_PROCESS(PhasedMemory);
  PhasedMemory(const sc_core::sc_module_name& name, std::uint64_t answers)
      : sc_module(name), answers_(answers) {
    socket.register_nb_transport_fw(this, &PhasedMemory::nb_transport_fw);
    SC_METHOD(respond);
    sensitive << due_;
    dont_initialize();
  }

 private:
  tlm::tlm_sync_enum nb_transport_fw(tlm::tlm_generic_payload& payload, tlm::tlm_phase& phase,
                                     sc_core::sc_time& delay) {
    if (phase == tlm::END_RESP) return tlm::TLM_COMPLETED;
    if (answers_ == 0) return tlm::TLM_ACCEPTED;
    --answers_;
    asked_ = &payload;
    due_.notify(delay + cycles(10));
    phase = tlm::END_REQ;
    return tlm::TLM_UPDATED;
  }
  void respond() {
    asked_->set_response_status(tlm::TLM_OK_RESPONSE);
    tlm::tlm_phase phase = tlm::BEGIN_RESP;
    sc_core::sc_time delay = cycles(2);
    socket->nb_transport_bw(*asked_, phase, delay);
  }

  sc_core::sc_event due_;
  tlm::tlm_generic_payload* asked_ = nullptr;
  std::uint64_t answers_;
};

TEST(Platform, WaitsForAMemoryThatAnswersInPhases) {
  const Plane plane(8);
  PhasedMemory memory("memory", 1000);
  BaseProtocolChecker last("last");
  Interconnect interconnect("interconnect", clock_period());
  PlatformUnit unit("unit", plane.config, plane.draws, plane.fragments);
  unit.after.out.bind(interconnect.in);
  interconnect.out.bind(last.in);
  last.out.bind(memory.socket);
  sc_core::sc_start();
  ASSERT_TRUE(unit.result);
  EXPECT_FALSE(unit.result->fault);
  unit.expect_clean();
  EXPECT_EQ(last.violations, std::vector<std::string>{});
  // The first line is asked for in cycle 6 (pushed in 5) and answered twelve later.
  ASSERT_EQ(unit.result->taken.size(), 64U);
  EXPECT_EQ(unit.result->answered.front(), 6U + 12);
}

TEST(Platform, ReportsAMemoryThatStopsAnswering) {
  const Plane plane(8);
  PhasedMemory memory("memory", 4);
  Interconnect interconnect("interconnect", clock_period());
  PlatformUnit unit("unit", plane.config, plane.draws, plane.fragments);
  unit.after.out.bind(interconnect.in);
  interconnect.out.bind(memory.socket);
  sc_core::sc_start();
  ASSERT_TRUE(unit.result);
  ASSERT_TRUE(unit.result->fault);
  EXPECT_NE(unit.result->fault->what.find("has not answered request 4"), std::string::npos)
      << unit.result->fault->what;
  unit.expect_clean();
}

/// Sends what a test wants to send.
class PlainInitiator final : public sc_core::sc_module, public tlm::tlm_mm_interface {
 public:
  tlm_utils::simple_initiator_socket<PlainInitiator> socket{"socket"};
  explicit PlainInitiator(const sc_core::sc_module_name& name) : sc_module(name) {}
  void free(tlm::tlm_generic_payload*) override {}
};

TEST(MemoryTarget, RefusesWhatIsNotAReadOfOneLine) {
  const Plane plane(8);
  MemoryTarget memory("memory", make_memory(FixedMemory{}), plane.lines, clock_period());
  PlainInitiator initiator("initiator");
  initiator.socket.bind(memory.socket);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  std::array<unsigned char, 128> data{};
  const auto status = [&](tlm::tlm_command command, std::uint64_t address, unsigned length) {
    tlm::tlm_generic_payload p;
    p.set_command(command);
    p.set_address(address);
    p.set_data_ptr(data.data());
    p.set_data_length(length);
    p.set_streaming_width(length);
    sc_core::sc_time delay;
    initiator.socket->b_transport(p, delay);
    EXPECT_EQ(p.is_response_ok(), delay == cycles(100));
    return p.get_response_status();
  };
  EXPECT_EQ(status(tlm::TLM_WRITE_COMMAND, 0, 64), tlm::TLM_COMMAND_ERROR_RESPONSE);
  EXPECT_EQ(status(tlm::TLM_READ_COMMAND, 0, 32), tlm::TLM_BURST_ERROR_RESPONSE);
  EXPECT_EQ(status(tlm::TLM_READ_COMMAND, 4, 64), tlm::TLM_ADDRESS_ERROR_RESPONSE);
  EXPECT_EQ(status(tlm::TLM_READ_COMMAND, plane.lines.size() * 64, 64),
            tlm::TLM_ADDRESS_ERROR_RESPONSE);
  EXPECT_EQ(status(tlm::TLM_READ_COMMAND, plane.lines.size() * 64 - 64, 64), tlm::TLM_OK_RESPONSE);
}

TEST(BaseProtocolChecker, SeesARequestThatIsAlreadyAnsweredAndAResponseEndedTwice) {
  const Plane plane(8);
  PlainInitiator rude("rude");
  BaseProtocolChecker checker("checker");
  MemoryTarget memory("memory", make_memory(FixedMemory{}), plane.lines, clock_period());
  rude.socket.bind(checker.in);
  checker.out.bind(memory.socket);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  reference::Line data{};
  tlm::tlm_generic_payload p(&rude);
  p.set_command(tlm::TLM_READ_COMMAND);
  p.set_address(0);
  p.set_data_ptr(reinterpret_cast<unsigned char*>(data.data()));
  p.set_data_length(64);
  p.set_streaming_width(64);
  p.set_response_status(tlm::TLM_OK_RESPONSE);
  sc_core::sc_time delay;
  tlm::tlm_phase phase = tlm::BEGIN_REQ;
  rude.socket->nb_transport_fw(p, phase, delay);
  EXPECT_EQ(checker.violations.size(), 2U) << "status set, and no reference held";
  phase = tlm::END_RESP;
  rude.socket->nb_transport_fw(p, phase, delay);
  EXPECT_EQ(checker.violations.size(), 2U);
  rude.socket->nb_transport_fw(p, phase, delay);
  EXPECT_EQ(checker.violations.size(), 3U);
}

}  // namespace
}  // namespace ptm::pipeline
