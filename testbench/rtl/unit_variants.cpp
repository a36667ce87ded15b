#include "testbench/rtl/unit_variants.h"

#include <dlfcn.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "model/reference/effects/stages.h"
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

constexpr reference::EvalConfig kSmallEffects{
    .rounding = reference::Rounding::truncate, .lum_frac = 4, .shift_groups = 3, .filter_frac = 2};
using reference::effects::kStages;
constexpr reference::UnitConfig with_effects(reference::UnitConfig unit, int sets, int passes,
                                             unsigned stages) {
  unit.extra_sets = sets;
  unit.extra_passes = passes;
  unit.half_vector = true;
  unit.stages = stages;
  return unit;
}
constexpr reference::UnitConfig one_tmu(reference::UnitConfig unit) {
  unit.tmus = 1;
  unit.miss_fifo = 13;  // no multiple of four
  return unit;
}

using reference::kBase;
using reference::kPaper8;
using reference::kWide;

const std::array<RtlUnitVariant, 10> kUnits{
    {{"base3", kBase, {}, make_rtl_unit_base3},
     {"base2", kBase, {.tmus = 2}, make_rtl_unit_base2},
     {"base1", kBase, {.tmus = 1}, make_rtl_unit_base1},
     {"bare", kBase, {.counters = false, .duplicate_lines = false}, make_rtl_unit_bare},
     {"paper8", kPaper8, {}, make_rtl_unit_paper8},
     {"wide", kWide, {}, make_rtl_unit_wide},
     {"effects", kBase, with_effects({}, 3, 4, kStages), make_rtl_unit_effects},
     {"specular", kBase, with_effects({}, 0, 1, kStages & 5U), make_rtl_unit_specular},
     {"small_effects", kSmallEffects, with_effects(one_tmu(kSmallUnit), 4, 4, kStages),
      make_rtl_unit_small_effects},
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
