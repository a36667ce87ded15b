#pragma once
#include <array>
#include <memory>
#include <span>

#include "model/reference/eval_config.h"
#include "testbench/rtl/verilated_unit.h"

/// Every variant of the unit that testbench/rtl/CMakeLists.txt verilates; others are built when
/// they are asked for (variant_cache.h).
namespace ptm::testbench {

[[nodiscard]] std::unique_ptr<RtlUnit> make_rtl_unit_base3();
[[nodiscard]] std::unique_ptr<RtlUnit> make_rtl_unit_base2();
[[nodiscard]] std::unique_ptr<RtlUnit> make_rtl_unit_base1();
[[nodiscard]] std::unique_ptr<RtlUnit> make_rtl_unit_paper8();
[[nodiscard]] std::unique_ptr<RtlUnit> make_rtl_unit_wide();
[[nodiscard]] std::unique_ptr<RtlUnit> make_rtl_unit_effects();
[[nodiscard]] std::unique_ptr<RtlUnit> make_rtl_unit_specular();
[[nodiscard]] std::unique_ptr<RtlUnit> make_rtl_unit_small_effects();
[[nodiscard]] std::unique_ptr<RtlUnit> make_rtl_unit_bare();
[[nodiscard]] std::unique_ptr<RtlUnit> make_rtl_unit_small();
/// A library of its own, ptm_rtl_unit_large, which only its test links.
[[nodiscard]] std::unique_ptr<RtlUnit> make_rtl_unit_large();

#ifdef PTM_VARIANT_LIBRARY
[[nodiscard]] std::unique_ptr<RtlUnit> make_rtl_unit_cached();
#endif

struct RtlUnitVariant {
  const char* name;
  reference::EvalConfig config;
  reference::UnitConfig unit;
  std::unique_ptr<RtlUnit> (*make)();
};

/// What ptmsim links. `bare` is `base3` without counters. `effects` has all that effects need,
/// `specular` what a half-vector's highlight does. `small` is everything small, so that all that
/// can be full is full, with the RTL's assertions built in; it is the last. `small_effects` is that
/// with all that effects need, one TMU, truncation and fraction bits.
[[nodiscard]] std::span<const RtlUnitVariant> rtl_unit_variants();

/// Null if no variant of those parameters comes with the build.
[[nodiscard]] const RtlUnitVariant* find_rtl_unit_variant(const reference::EvalConfig& config,
                                                          const reference::UnitConfig& unit);

}  // namespace ptm::testbench
