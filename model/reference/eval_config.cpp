#include "model/reference/eval_config.h"

#include <stdexcept>
#include <string>

namespace ptm::reference {

const Preset& find_preset(std::string_view name) {
  std::string known;
  for (const Preset& preset : kPresets) {
    if (preset.name == name) return preset;
    known += known.empty() ? "" : ", ";
    known += preset.name;
  }
  throw std::invalid_argument("preset '" + std::string(name) + "', expected one of " + known);
}

void validate(const EvalConfig& config) { validate_parameters(config); }

std::array<NamedParameter, ParameterTable<EvalConfig>::kCount> rtl_parameters(
    const EvalConfig& config) {
  using Table = ParameterTable<EvalConfig>;
  std::array<NamedParameter, Table::kCount> all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = {Table::rows()[i].rtl, Table::get(config, i)};
  }
  return all;
}

}  // namespace ptm::reference
