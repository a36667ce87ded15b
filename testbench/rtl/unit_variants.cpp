#include "testbench/rtl/unit_variants.h"

#include <stdexcept>
#include <string>

#include "model/reference/effects/stages.h"

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
  return unit;
}

using reference::kBase;
using reference::kPaper8;
using reference::kWide;

const std::array<RtlUnitVariant, 9> kUnits{
    {{"base3", kBase, {}, make_rtl_unit_base3},
     {"base2", kBase, {.tmus = 2}, make_rtl_unit_base2},
     {"base1", kBase, {.tmus = 1}, make_rtl_unit_base1},
     {"paper8", kPaper8, {}, make_rtl_unit_paper8},
     {"wide", kWide, {}, make_rtl_unit_wide},
     {"effects", kBase, with_effects({}, 4, 4, kStages), make_rtl_unit_effects},
     {"specular", kBase, with_effects({}, 0, 1, kStages & 5U), make_rtl_unit_specular},
     {"small_effects", kSmallEffects, with_effects(one_tmu(kSmallUnit), 4, 4, kStages),
      make_rtl_unit_small_effects},
     {"small", kSmallGroups, kSmallUnit, make_rtl_unit_small}}};

std::string describe(const RtlUnitVariant& variant) {
  const reference::UnitConfig& unit = variant.unit;
  return std::string(variant.name) + " (tmus " + std::to_string(unit.tmus) + ", cache_kib " +
         std::to_string(unit.cache_kib) + ", ways " + std::to_string(unit.ways) +
         ", fragment_fifo " + std::to_string(unit.fragment_fifo) + ", miss_fifo " +
         std::to_string(unit.miss_fifo) + ", shift_groups " +
         std::to_string(variant.config.shift_groups) + ", palette ports " +
         std::to_string(unit.palette_lrgb_ports) + " and " +
         std::to_string(unit.palette_rgb_ports) + ", eval_lanes " +
         std::to_string(unit.eval_lanes) +
         (unit.extra_passes == 0 && unit.stages == 0
              ? std::string()
              : ", extra_sets " + std::to_string(unit.extra_sets) + ", extra_passes " +
                    std::to_string(unit.extra_passes) + ", half_vector " +
                    std::to_string(unit.half_vector) + ", stages " + std::to_string(unit.stages)) +
         ")";
}

}  // namespace

std::span<const RtlUnitVariant> rtl_unit_variants() { return kUnits; }

std::unique_ptr<RtlUnit> make_rtl_unit(const reference::EvalConfig& config,
                                       const reference::UnitConfig& unit) {
  std::string built;
  for (const RtlUnitVariant& variant : kUnits) {
    if (variant.config == config && variant.unit == unit) return variant.make();
    built += (built.empty() ? "" : "; ") + describe(variant);
  }
  throw std::invalid_argument("no RTL unit is built with these parameters; there is: " + built);
}

}  // namespace ptm::testbench
