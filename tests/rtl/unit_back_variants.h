#pragma once
#include "Vptm_back_corner.h"
#include "Vptm_back_default.h"
#include "Vptm_back_narrow.h"
#include "contract/rtl_variants.h"

/// The builds of the unit's back; contract/variants.toml.
namespace ptm::tests {

struct BackDefault {
  using Dut = Vptm_back_default;
  static constexpr reference::EvalConfig config = testbench::variants::back_default_evaluator;
  static constexpr reference::UnitConfig unit = testbench::variants::back_default_unit;
};
struct BackCorner {
  using Dut = Vptm_back_corner;
  static constexpr reference::EvalConfig config = testbench::variants::back_corner_evaluator;
  static constexpr reference::UnitConfig unit = testbench::variants::back_corner_unit;
};
struct BackNarrow {
  using Dut = Vptm_back_narrow;
  static constexpr reference::EvalConfig config = testbench::variants::back_narrow_evaluator;
  static constexpr reference::UnitConfig unit = testbench::variants::back_narrow_unit;
};

}  // namespace ptm::tests
