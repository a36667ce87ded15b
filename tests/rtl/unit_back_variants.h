#pragma once
#include <array>

#include "Vptm_back_corner.h"
#include "Vptm_back_default.h"
#include "Vptm_back_narrow.h"
#include "model/reference/eval_config.h"
#include "model/reference/unit/unit_config.h"

/// The builds of tests/rtl/CMakeLists.txt.
namespace ptm::tests {

struct BackDefault {
  using Dut = Vptm_back_default;
  static constexpr reference::EvalConfig config = reference::kBase;
  static constexpr reference::UnitConfig unit{.tmus = 3};
};
/// The widest values of the unit, two TMUs, few ports; the RTL's assertions are built in.
struct BackCorner {
  using Dut = Vptm_back_corner;
  static constexpr reference::EvalConfig config{.coef_bits = 10,
                                                .delta_bits = 11,
                                                .light_int = 3,
                                                .light_frac = 14,
                                                .basis_frac = 28,
                                                .guard = 12,
                                                .rounding = reference::Rounding::nearest,
                                                .lum_bits = 12,
                                                .lum_frac = 4,
                                                .shift_min = -8,
                                                .shift_groups = 6,
                                                .filter_frac = 4};
  static constexpr reference::UnitConfig unit{
      .tmus = 2, .palette_lrgb_ports = 1, .palette_rgb_ports = 2};
};
/// Coefficients narrower than a colour, truncation, one TMU, many ports.
struct BackNarrow {
  using Dut = Vptm_back_narrow;
  static constexpr reference::EvalConfig config{.coef_bits = 5,
                                                .delta_bits = 6,
                                                .light_int = 1,
                                                .light_frac = 4,
                                                .basis_frac = 4,
                                                .guard = 0,
                                                .rounding = reference::Rounding::truncate,
                                                .lum_bits = 8,
                                                .lum_frac = 0,
                                                .shift_min = 0,
                                                .shift_groups = 3,
                                                .filter_frac = 1};
  static constexpr reference::UnitConfig unit{
      .tmus = 1, .palette_lrgb_ports = 2, .palette_rgb_ports = 4};
};

}  // namespace ptm::tests
