// The evaluator as CXXRTL simulates it. The generated header's folder is given with -I.
#include "evaluator_cxxrtl.h"
#include "tests/rtl/cxxrtl/ports.h"
#include "tests/rtl/cxxrtl/simulation.h"

namespace ptm::tests {
namespace {

class Evaluator final : public CxxrtlEvaluator {
 public:
  Evaluator() {
    set_port(dut_.p_rst__ni, 0);
    clock_cycle();
    set_port(dut_.p_rst__ni, 1);
    dut_.step();
  }

  testbench::RtlSeen cycle(const testbench::RtlPins& pins) override {
    set_port(dut_.p_valid__i, pins.valid);
    set_port(dut_.p_ready__i, pins.ready);
    set_port(dut_.p_rgb__map__i, pins.rgb_map);
    set_port(dut_.p_channel__i, pins.channel);
    set_port(dut_.p_sideband__i, pins.sideband);
    const reference::LrgbOperands<>& in = pins.operands;
    for (unsigned i = 0; i < 6; ++i) {
      set_part(dut_.p_coef__i, i, 6, in.coef[i]);
      set_part(dut_.p_bias__i, i, 6, in.bias[i]);
      set_part(dut_.p_shift__i, i, 6, in.shift[i]);
    }
    for (unsigned c = 0; c < 3; ++c) set_part(dut_.p_rgb__i, c, 3, in.rgb[c]);
    set_port(dut_.p_lu__i, static_cast<std::uint32_t>(in.lu));
    set_port(dut_.p_lv__i, static_cast<std::uint32_t>(in.lv));
    dut_.step();
    testbench::RtlSeen seen{port_bits(dut_.p_ready__o) != 0,
                            port_bits(dut_.p_valid__o) != 0,
                            {},
                            port_bits(dut_.p_sideband__o)};
    for (unsigned c = 0; c < 3; ++c) {
      seen.pixel.lum[c] = static_cast<std::uint16_t>(part(dut_.p_lum__o, c, 3));
      seen.pixel.out[c] = static_cast<std::uint8_t>(part(dut_.p_rgb__o, c, 3));
    }
    seen.pixel.lum_saturated = port_bits(dut_.p_lum__saturated__o) != 0;
    seen.pixel.color_saturated = port_bits(dut_.p_color__saturated__o) != 0;
    clock_cycle();
    return seen;
  }

 private:
  /// One of `parts` equal fields of a port, the first one lowest.
  template <std::size_t Bits>
  static void set_part(cxxrtl::value<Bits>& port, unsigned index, unsigned parts,
                       reference::Value value) {
    set_field(port, index * (Bits / parts), Bits / parts, static_cast<std::uint32_t>(value));
  }
  template <std::size_t Bits>
  static std::uint32_t part(const cxxrtl::value<Bits>& port, unsigned index, unsigned parts) {
    return field(port, index * (Bits / parts), Bits / parts);
  }

  void clock_cycle() {
    set_port(dut_.p_clk__i, 1);
    dut_.step();
    set_port(dut_.p_clk__i, 0);
    dut_.step();
  }

  evaluator_cxxrtl::p_ptm__evaluator dut_;
};

}  // namespace
}  // namespace ptm::tests

extern "C" ptm::tests::CxxrtlEvaluator* ptm_make_cxxrtl() { return new ptm::tests::Evaluator; }
