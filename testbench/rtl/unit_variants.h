#pragma once
#include <memory>
#include <span>

#include "contract/rtl_variants.h"
#include "testbench/rtl/verilated_unit.h"

/// Every variant of the unit that comes with the build (contract/variants.toml); others are built
/// when they are asked for (variant_cache.h).
namespace ptm::testbench {

#define PTM_DECLARE(name) [[nodiscard]] std::unique_ptr<RtlUnit> make_rtl_unit_##name();
PTM_RTL_UNITS(PTM_DECLARE)
PTM_RTL_TEST_UNITS(PTM_DECLARE)  // libraries of their own, ptm_rtl_unit_<name>
#undef PTM_DECLARE

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
