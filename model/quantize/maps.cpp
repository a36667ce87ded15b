#include "model/quantize/maps.h"

#include <cmath>

namespace ptm::quantize {

std::string_view to_string(Origin origin) {
  switch (origin) {
    case Origin::verbatim:
      return "verbatim";
    case Origin::plain:
      return "plain";
    case Origin::nearest_plane:
      return "nearest_plane";
  }
  return "unknown";
}

std::vector<double> dequantize(const StoredMap& stored) {
  std::vector<double> real(stored.coef.size());
  Six<double> scale{};
  for (std::size_t i = 0; i < kSix; ++i) scale[i] = std::ldexp(1.0, -stored.shift[i]);
  for (std::size_t k = 0; k < real.size(); ++k) {
    const std::size_t i = k % kSix;
    real[k] = (static_cast<int>(stored.coef[k]) - stored.bias[i]) * scale[i];
  }
  return real;
}

}  // namespace ptm::quantize
