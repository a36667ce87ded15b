#include "model/reference/light_code.h"

#include <algorithm>
#include <cmath>

namespace ptm::reference {

double light_limit(const EvalConfig& config) { return 1 << (config.light_int - 1); }

std::optional<Value> light_code(const EvalConfig& config, double l) {
  if (!(std::abs(l) <= light_limit(config))) return std::nullopt;  // false for NaN too
  const auto scale = static_cast<double>(Value{1} << config.light_frac);
  const auto code = static_cast<Value>(std::floor(l * scale + 0.5));
  const Value limit = (Value{1} << (config.light_int - 1 + config.light_frac)) - 1;
  return std::clamp(code, -limit, limit);
}

}  // namespace ptm::reference
