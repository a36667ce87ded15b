#include "model/reference/unit/unit_config.h"

namespace ptm::reference {

void validate(const UnitConfig& config) { validate_parameters(config); }

std::optional<ParameterFault> unit_fault(const EvalConfig& config, const UnitConfig& unit) {
  if (auto fault = ParameterTable<EvalConfig>::fault(config)) return fault;
  return ParameterTable<UnitConfig>::fault(unit);
}

}  // namespace ptm::reference
