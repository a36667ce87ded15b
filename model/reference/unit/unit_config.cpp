#include "model/reference/unit/unit_config.h"

namespace ptm::reference {

void validate(const UnitConfig& config) { validate_parameters(config); }

std::optional<ParameterFault> unit_fault(const EvalConfig& config, const UnitConfig& unit) {
  if (auto fault = ParameterTable<EvalConfig>::fault(config)) return fault;
  for (const UnitLimit& limit : kUnitLimits) {
    const std::int64_t value =
        ParameterTable<EvalConfig>::get(config, find_parameter<EvalConfig>(limit.name).value());
    if (value <= limit.most) continue;
    return ParameterFault{std::string(limit.name), std::to_string(value),
                          "at most " + std::to_string(limit.most) + " in the whole unit, where " +
                              std::string(limit.why)};
  }
  return ParameterTable<UnitConfig>::fault(unit);
}

}  // namespace ptm::reference
