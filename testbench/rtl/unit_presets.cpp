#include <stdexcept>
#include <string>

#include "testbench/rtl/unit_variants.h"

namespace ptm::testbench {
namespace {

using reference::kBase;
using reference::kPaper8;
using reference::kWide;

const std::array<RtlUnitVariant, 5> kPresetUnits{
    {{"base3", kBase, {}, make_rtl_unit_base3},
     {"base2", kBase, {.tmus = 2}, make_rtl_unit_base2},
     {"base1", kBase, {.tmus = 1}, make_rtl_unit_base1},
     {"paper8", kPaper8, {}, make_rtl_unit_paper8},
     {"wide", kWide, {}, make_rtl_unit_wide}}};

std::string describe(const RtlUnitVariant& variant) {
  return std::string(variant.name) + " (tmus " + std::to_string(variant.unit.tmus) + ")";
}

}  // namespace

std::span<const RtlUnitVariant> rtl_unit_presets() { return kPresetUnits; }

std::unique_ptr<RtlUnit> make_rtl_unit(std::string_view preset, const reference::UnitConfig& unit) {
  const reference::EvalConfig& config = reference::find_preset(preset).config;
  std::string built;
  for (const RtlUnitVariant& variant : kPresetUnits) {
    if (variant.config == config && variant.unit == unit) return variant.make();
    built += (built.empty() ? "" : ", ") + describe(variant);
  }
  throw std::invalid_argument("the unit with preset '" + std::string(preset) + "', tmus " +
                              std::to_string(unit.tmus) +
                              " and these parameters is not built as RTL; there is: " + built +
                              ", all else at its default");
}

}  // namespace ptm::testbench
