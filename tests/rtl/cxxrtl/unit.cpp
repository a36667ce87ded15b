// The texture unit as CXXRTL simulates it. The generated header's folder is given with -I.
#include "tests/rtl/cxxrtl/ports.h"
#include "tests/rtl/cxxrtl/simulation.h"
#include "unit_cxxrtl.h"

namespace ptm::tests {
namespace {

class Unit final : public CxxrtlUnit {
 public:
  Unit() {
    set_port(dut_.p_rst__ni, 0);
    set_port(dut_.p_mem__rst__ni, 0);
    set_port(dut_.p_mem__req__ready__i, 1);
    clock_cycle();
    set_port(dut_.p_rst__ni, 1);
    set_port(dut_.p_mem__rst__ni, 1);
    dut_.step();
  }

  testbench::RtlUnitSeen cycle(const testbench::RtlUnitPins& pins) override {
    drive(pins.fragment);
    set_port(dut_.p_frag__valid__i, pins.valid);
    set_port(dut_.p_pix__ready__i, pins.pixel_ready);
    set_port(dut_.p_mem__req__ready__i, pins.request_ready);
    set_port(dut_.p_mem__rsp__valid__i, pins.response);
    set_port(dut_.p_mem__rsp__tag__i, pins.tag);
    set_port(dut_.p_mem__rsp__error__i, pins.failed);
    for (unsigned w = 0; w < reference::kLineWords; ++w) {
      dut_.p_mem__rsp__line__i.data[w] = pins.line[w];
    }
    if (pins.write) {
      set_port(dut_.p_reg__we__i, 1);
      set_port(dut_.p_reg__addr__i, pins.write->address);
      set_port(dut_.p_reg__wdata__i, pins.write->data);
    }
    dut_.step();
    testbench::RtlUnitSeen seen;
    seen.ready = port_bits(dut_.p_frag__ready__o) != 0;
    seen.pixel_valid = port_bits(dut_.p_pix__valid__o) != 0;
    seen.pixel = {static_cast<std::uint16_t>(port_bits(dut_.p_pix__x__o)),
                  static_cast<std::uint16_t>(port_bits(dut_.p_pix__y__o)),
                  {static_cast<std::uint8_t>(field(dut_.p_pix__rgb__o, 0, 8)),
                   static_cast<std::uint8_t>(field(dut_.p_pix__rgb__o, 8, 8)),
                   static_cast<std::uint8_t>(field(dut_.p_pix__rgb__o, 16, 8))},
                  static_cast<std::uint8_t>(port_bits(dut_.p_pix__alpha__o)),
                  port_bits(dut_.p_pix__lum__saturated__o) != 0,
                  port_bits(dut_.p_pix__color__saturated__o) != 0,
                  port_bits(dut_.p_pix__mem__error__o) != 0};
    seen.request = port_bits(dut_.p_mem__req__valid__o) != 0;
    seen.line = port_bits(dut_.p_mem__req__line__o);
    seen.tag = static_cast<std::uint8_t>(port_bits(dut_.p_mem__req__tag__o));
    seen.interrupt = port_bits(dut_.p_irq__o) != 0;
    clock_cycle();
    set_port(dut_.p_reg__we__i, 0);
    return seen;
  }

  void write(std::uint16_t address, std::uint32_t data) override {
    set_port(dut_.p_frag__valid__i, 0);
    set_port(dut_.p_pix__ready__i, 0);
    set_port(dut_.p_mem__rsp__valid__i, 0);
    set_port(dut_.p_reg__we__i, 1);
    set_port(dut_.p_reg__addr__i, address);
    set_port(dut_.p_reg__wdata__i, data);
    dut_.step();
    clock_cycle();
    set_port(dut_.p_reg__we__i, 0);
  }

  std::uint32_t read(std::uint16_t address) override {
    set_port(dut_.p_reg__addr__i, address);
    dut_.step();
    return port_bits(dut_.p_reg__rdata__o);
  }

 private:
  void drive(const reference::UnitFragment& f) {
    set_port(dut_.p_frag__x__i, f.x);
    set_port(dut_.p_frag__y__i, f.y);
    set_port(dut_.p_frag__u__i, static_cast<std::uint32_t>(f.u));
    set_port(dut_.p_frag__v__i, static_cast<std::uint32_t>(f.v));
    set_port(dut_.p_frag__lod__i, f.lod);
    set_port(dut_.p_frag__axis__u__i, static_cast<std::uint32_t>(f.axis_u));
    set_port(dut_.p_frag__axis__v__i, static_cast<std::uint32_t>(f.axis_v));
    set_port(dut_.p_frag__probes__log2__i, f.probes_log2);
    set_port(dut_.p_frag__lu__i, static_cast<std::uint32_t>(f.lu));
    set_port(dut_.p_frag__lv__i, static_cast<std::uint32_t>(f.lv));
    set_port(dut_.p_frag__hu__i, static_cast<std::uint32_t>(f.hu));
    set_port(dut_.p_frag__hv__i, static_cast<std::uint32_t>(f.hv));
    set_port(dut_.p_frag__lit__i, f.lit);
    set_port(dut_.p_frag__draw__i, f.draw);
  }

  void clock_cycle() {
    set_port(dut_.p_clk__i, 1);
    dut_.step();
    set_port(dut_.p_clk__i, 0);
    dut_.step();
  }

  unit_cxxrtl::p_ptm__unit dut_;
};

}  // namespace
}  // namespace ptm::tests

extern "C" ptm::tests::CxxrtlUnit* ptm_make_cxxrtl() { return new ptm::tests::Unit; }
