#pragma once
#include <array>
#include <memory>

#include "testbench/rtl/verilated_evaluator.h"

/// Every variant that testbench/rtl/CMakeLists.txt verilates: the presets, and two corners of the
/// stated ranges for tests.
namespace ptm::testbench {

[[nodiscard]] std::unique_ptr<RtlEvaluator> make_rtl_paper8();
[[nodiscard]] std::unique_ptr<RtlEvaluator> make_rtl_base();
[[nodiscard]] std::unique_ptr<RtlEvaluator> make_rtl_wide();
[[nodiscard]] std::unique_ptr<RtlEvaluator> make_rtl_small();
[[nodiscard]] std::unique_ptr<RtlEvaluator> make_rtl_large();

inline constexpr reference::EvalConfig kSmall{.coef_bits = 4,
                                              .delta_bits = 5,
                                              .light_int = 1,
                                              .light_frac = 4,
                                              .basis_frac = 4,
                                              .guard = 0,
                                              .rounding = reference::Rounding::truncate,
                                              .lum_bits = 8,
                                              .lum_frac = 0,
                                              .shift_min = 0,
                                              .shift_groups = 3,
                                              .filter_frac = 0};
inline constexpr reference::EvalConfig kLarge{.coef_bits = 12,
                                              .delta_bits = 13,
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

struct RtlVariant {
  const char* name;
  reference::EvalConfig config;
  std::unique_ptr<RtlEvaluator> (*make)();
};
/// All five; needs the library ptm_rtl_corners.
[[nodiscard]] const std::array<RtlVariant, 5>& rtl_variants();

}  // namespace ptm::testbench
