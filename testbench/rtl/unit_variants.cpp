#include "testbench/rtl/unit_variants.h"

#include <dlfcn.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "testbench/rtl/variant_cache.h"

namespace ptm::testbench {
namespace {

/// Everything small, so that all that can be full is full.
constexpr reference::EvalConfig kSmallGroups{.shift_groups = 3};
constexpr reference::UnitConfig kSmallUnit{.tmus = 3,
                                           .cache_kib = 1,
                                           .ways = 1,
                                           .fragment_fifo = 8,
                                           .miss_fifo = 12,
                                           .palette_lrgb_ports = 2,
                                           .palette_rgb_ports = 2,
                                           .eval_lanes = 3};

using reference::kBase;
using reference::kPaper8;
using reference::kWide;

const std::array<RtlUnitVariant, 6> kUnits{
    {{"base3", kBase, {}, make_rtl_unit_base3},
     {"base2", kBase, {.tmus = 2}, make_rtl_unit_base2},
     {"base1", kBase, {.tmus = 1}, make_rtl_unit_base1},
     {"paper8", kPaper8, {}, make_rtl_unit_paper8},
     {"wide", kWide, {}, make_rtl_unit_wide},
     {"small", kSmallGroups, kSmallUnit, make_rtl_unit_small}}};

/// A library's unit, which must not outlive the library: libraries are never closed.
std::unique_ptr<RtlUnit> load_unit(const std::filesystem::path& library) {
  using Make = RtlUnit*();
  void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const symbol = handle ? dlsym(handle, "ptm_make_unit") : nullptr;
  if (!symbol) throw std::runtime_error(std::string("an RTL unit cannot be loaded: ") + dlerror());
  return std::unique_ptr<RtlUnit>(reinterpret_cast<Make*>(symbol)());
}

}  // namespace

std::span<const RtlUnitVariant> rtl_unit_variants() { return kUnits; }

const RtlUnitVariant* find_rtl_unit_variant(const reference::EvalConfig& config,
                                            const reference::UnitConfig& unit) {
  const auto found = std::find_if(kUnits.begin(), kUnits.end(), [&](const RtlUnitVariant& variant) {
    return variant.config == config && variant.unit == unit;
  });
  return found == kUnits.end() ? nullptr : &*found;
}

std::unique_ptr<RtlUnit> make_rtl_unit(const reference::EvalConfig& config,
                                       const reference::UnitConfig& unit) {
  const RtlUnitVariant* variant = find_rtl_unit_variant(config, unit);
  return variant ? variant->make() : load_unit(build_variant(config, unit));
}

}  // namespace ptm::testbench
