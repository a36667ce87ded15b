// A unit that breaks the stream's protocol is reported with cycle and item, and never hangs the
// test bench. The units are fakes with the ports of the Verilated class.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "testbench/rtl/verilated_evaluator_impl.h"

namespace ptm::testbench {
namespace {

/// The ports; a fake decides in eval() what stands on the outputs.
struct FakePorts {
  explicit FakePorts(VerilatedContext*) {}
  void final() {}
  FakePorts* rootp = this;  ///< where Verilator keeps the pins

  CData clk_i = 0, rst_ni = 0, valid_i = 0, ready_i = 0, rgb_map_i = 0, channel_i = 0, probe_i = 0;
  CData ready_o = 0, valid_o = 0, lum_saturated_o = 0, color_saturated_o = 0;
  std::array<SData, 6> coef_i{}, bias_i{};
  std::array<CData, 6> shift_i{};
  std::array<SData, 3> rgb_i{}, lum_o{};
  std::array<CData, 3> rgb_o{};
  IData lu_i = 0, lv_i = 0, sideband_i = 0, sideband_o = 0;
  QData probe_o = 0;
};

struct NeverReady : FakePorts {
  using FakePorts::FakePorts;
  void eval() {}
};
struct NeverValid : FakePorts {
  using FakePorts::FakePorts;
  void eval() { ready_o = 1; }
};
struct ValidWithoutOperands : FakePorts {
  using FakePorts::FakePorts;
  void eval() { valid_o = 1; }
};
/// Gives every pixel the id 0.
struct SameIdAlways : FakePorts {
  using FakePorts::FakePorts;
  void eval() {
    ready_o = 1;
    valid_o = valid_i;
  }
};
/// Right, but one pixel goes on being offered.
struct OneTooMany : FakePorts {
  using FakePorts::FakePorts;
  void eval() {
    ready_o = 1;
    valid_o = valid_o != 0 || valid_i != 0;
    sideband_o = sideband_i;
  }
};

template <class Dut>
std::string failure(std::size_t pixels) {
  VerilatedEvaluator<Dut, false> rtl("fake");
  const std::vector<reference::LrgbOperands<>> operands(pixels);
  try {
    static_cast<void>(rtl.run(operands, {}));
  } catch (const RtlProtocolError& error) {
    return error.what();
  }
  return "no error";
}

TEST(RtlWatchdog, ReportsAUnitThatNeverAccepts) {
  EXPECT_EQ(failure<NeverReady>(3), "rtl fake: the unit hangs in cycle 64, waiting for pixel 0");
}

TEST(RtlWatchdog, ReportsAUnitThatNeverGivesAPixel) {
  EXPECT_EQ(failure<NeverValid>(3), "rtl fake: the unit hangs in cycle 67, waiting for pixel 0");
}

TEST(RtlWatchdog, ReportsAPixelBeforeItsOperands) {
  EXPECT_EQ(failure<ValidWithoutOperands>(3),
            "rtl fake: a pixel before its operands in cycle 0, pixel 0");
}

TEST(RtlWatchdog, ReportsAPixelWithAnothersId) {
  EXPECT_EQ(failure<SameIdAlways>(3), "rtl fake: another pixel's id in cycle 2, pixel 1");
}

TEST(RtlWatchdog, ReportsAPixelTooMany) {
  EXPECT_EQ(failure<OneTooMany>(1), "rtl fake: a pixel too many in cycle 2, after pixel 1");
}

}  // namespace
}  // namespace ptm::testbench
