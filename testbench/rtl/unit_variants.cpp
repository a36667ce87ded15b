#include "testbench/rtl/unit_variants.h"

#include <algorithm>

#include "testbench/rtl/variant_cache.h"

namespace ptm::testbench {
namespace {

#define PTM_VARIANT_ROW(name) \
  {#name, variants::unit_##name##_evaluator, variants::unit_##name##_unit, make_rtl_unit_##name},
constexpr RtlUnitVariant kUnits[] = {PTM_RTL_UNITS(PTM_VARIANT_ROW)};
#undef PTM_VARIANT_ROW

}  // namespace

std::span<const RtlUnitVariant> rtl_unit_variants() { return kUnits; }

const RtlUnitVariant* find_rtl_unit_variant(const reference::EvalConfig& config,
                                            const reference::UnitConfig& unit) {
  const auto found =
      std::find_if(std::begin(kUnits), std::end(kUnits), [&](const RtlUnitVariant& variant) {
        return variant.config == config && variant.unit == unit;
      });
  return found == std::end(kUnits) ? nullptr : &*found;
}

std::unique_ptr<RtlUnit> make_rtl_unit(const reference::EvalConfig& config,
                                       const reference::UnitConfig& unit) {
  const RtlUnitVariant* variant = find_rtl_unit_variant(config, unit);
  return variant ? variant->make()
                 : load_variant<RtlUnit>(build_variant(config, unit), "ptm_make_unit");
}

}  // namespace ptm::testbench
