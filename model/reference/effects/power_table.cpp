#include "model/reference/effects/power_table.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace ptm::reference {

EffectTable effect_table(double exponent) {
  if (!(exponent >= 1 && exponent <= 255)) {  // true for NaN too
    throw std::invalid_argument("exponent = " + std::to_string(exponent) + ", expected 1 to 255");
  }
  EffectTable table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double share = static_cast<double>(i) / 255;
    const double level = std::floor(kPowerTop * std::pow(share, exponent) + 0.5);
    table[i] = static_cast<std::uint16_t>(level);
  }
  return table;
}

}  // namespace ptm::reference
