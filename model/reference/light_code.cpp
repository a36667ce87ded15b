#include "model/reference/light_code.h"

#include <algorithm>
#include <cmath>

namespace ptm::reference {

double light_limit(const EvalConfig& config) { return std::ldexp(1.0, config.light_int - 1); }

std::optional<Value> light_code(const EvalConfig& config, double l) {
  if (!(std::abs(l) <= light_limit(config))) return std::nullopt;  // false for NaN too
  const auto code = static_cast<Value>(std::floor(std::ldexp(l, config.light_frac) + 0.5));
  const Value limit = (Value{1} << (config.light_int - 1 + config.light_frac)) - 1;
  return std::clamp(code, -limit, limit);
}

}  // namespace ptm::reference
