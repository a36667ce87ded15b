#include <verilated.h>

#include "Vptm_lerp.h"
#include "testbench/rtl/verilated_evaluator.h"

namespace ptm::testbench {
namespace {

class VerilatedLerp final : public RtlLerp {
 public:
  ~VerilatedLerp() override { dut_.final(); }

  unsigned operator()(reference::Rounding rounding, int width, unsigned a, unsigned b,
                      unsigned f) override {
    dut_.a_i = static_cast<SData>(a);
    dut_.b_i = static_cast<SData>(b);
    dut_.f_i = static_cast<CData>(f);
    dut_.eval();
    const bool nearest = rounding == reference::Rounding::nearest;
    if (width == 8) return nearest ? dut_.nearest8_o : dut_.truncate8_o;
    return nearest ? dut_.nearest16_o : dut_.truncate16_o;
  }

 private:
  VerilatedContext context_;
  Vptm_lerp dut_{&context_};
};

}  // namespace

std::unique_ptr<RtlLerp> make_rtl_lerp() { return std::make_unique<VerilatedLerp>(); }

}  // namespace ptm::testbench
