#include "model/reference/eval_config.h"

#include <stdexcept>

namespace ptm::reference {
namespace {

void require(std::string_view field, int value, int low, int high) {
  if (value < low || value > high) {
    throw std::invalid_argument(std::string(field) + " = " + std::to_string(value) + ", expected " +
                                std::to_string(low) + " to " + std::to_string(high));
  }
}

}  // namespace

const Preset& find_preset(std::string_view name) {
  std::string known;
  for (const Preset& preset : kPresets) {
    if (preset.name == name) return preset;
    known += known.empty() ? "" : ", ";
    known += preset.name;
  }
  throw std::invalid_argument("preset '" + std::string(name) + "', expected one of " + known);
}

void validate(const EvalConfig& c) {
  require("coef_bits", c.coef_bits, 4, 12);
  require("delta_bits", c.delta_bits, 5, 13);
  require("light_int", c.light_int, 1, 3);
  require("light_frac", c.light_frac, 4, 14);
  require("basis_frac", c.basis_frac, 4, 2 * c.light_frac);
  require("guard", c.guard, 0, 12);
  require("lum_bits", c.lum_bits, 8, 12);
  require("lum_frac", c.lum_frac, 0, 4);
  require("shift_min", c.shift_min, -8, 0);
  if (c.shift_groups != 3) require("shift_groups", c.shift_groups, 6, 6);
  require("filter_frac", c.filter_frac, 0, 4);
}

std::array<NamedParameter, 12> rtl_parameters(const EvalConfig& c) {
  return {{{"CoefBits", c.coef_bits},
           {"DeltaBits", c.delta_bits},
           {"LightInt", c.light_int},
           {"LightFrac", c.light_frac},
           {"BasisFrac", c.basis_frac},
           {"Guard", c.guard},
           {"RoundNearest", c.rounding == Rounding::nearest ? 1 : 0},
           {"LumBits", c.lum_bits},
           {"LumFrac", c.lum_frac},
           {"ShiftMin", c.shift_min},
           {"ShiftGroups", c.shift_groups},
           {"FilterFrac", c.filter_frac}}};
}

}  // namespace ptm::reference
