#include "model/quantize/import.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "model/quantize/grid.h"

namespace ptm::quantize {
namespace {

using reference::EvalConfig;

template <class... Parts>
std::string sentence(const Parts&... parts) {
  std::ostringstream out;
  (out << ... << parts);
  return out.str();
}

/// The shift of a scale, or why there is none.
std::string find_shift(double scale, std::size_t i, const EvalConfig& config, int& shift) {
  int exponent = 0;
  if (!(scale > 0) || std::frexp(scale, &exponent) != 0.5) {
    return sentence("scale ", i, " is ", scale, ", not a power of two");
  }
  shift = 1 - exponent;
  if (shift < config.shift_min || shift > reference::kShiftMax) {
    return sentence("scale ", i, " is 2^", -shift, ", the hardware shifts by ", config.shift_min,
                    " to ", reference::kShiftMax);
  }
  return {};
}

std::string check_groups(const Six<int>& shift, const EvalConfig& config) {
  for (std::size_t i = 0; i < kSix; ++i) {
    const std::size_t first = shift_group(config, i).front();
    if (shift[i] != shift[first]) {
      return sentence("scales ", first, " and ", i,
                      " differ, the hardware has one shift for both (shift_groups = 3)");
    }
  }
  return {};
}

/// Whether the bytes of coefficient i, whose least and greatest are given, can be held.
std::string check_values(std::size_t i, int low, int high, int bias, const EvalConfig& config) {
  const int top = coef_top(config);
  if (bias < 0 || bias > top) {
    return sentence("bias ", i, " is ", bias, ", the hardware holds 0 to ", top);
  }
  if (high > top) {
    return sentence("coefficient ", i, " reaches ", high, ", the hardware holds 0 to ", top);
  }
  const Window window = delta_window(config, bias);
  for (const int value : {low, high}) {
    if (value - bias < window.low || value - bias > window.high) {
      return sentence("coefficient ", i, " less its bias reaches ", value - bias,
                      ", beyond delta_bits = ", config.delta_bits);
    }
  }
  return {};
}

}  // namespace

Import import_verbatim(const FileCoefficients& file, const EvalConfig& config) {
  reference::validate(config);
  check_size(file.width, file.height, file.polynomials, file.coef.size());
  StoredMap map{.width = file.width, .height = file.height, .polynomials = file.polynomials};
  for (std::size_t i = 0; i < kSix; ++i) {
    std::string why = find_shift(file.scale[i], i, config, map.shift[i]);
    if (!why.empty()) return {{}, why};
  }
  if (std::string why = check_groups(map.shift, config); !why.empty()) return {{}, why};
  Six<int> low, high{};
  low.fill(255);
  for (std::size_t k = 0; k < file.coef.size(); k += kSix) {
    for (std::size_t i = 0; i < kSix; ++i) {
      const int byte = file.coef[k + i];
      low[i] = std::min(low[i], byte);
      high[i] = std::max(high[i], byte);
    }
  }
  for (std::size_t i = 0; i < kSix; ++i) {
    std::string why = check_values(i, low[i], high[i], file.bias[i], config);
    if (!why.empty()) return {{}, why};
    map.bias[i] = file.bias[i];
  }
  map.coef.assign(file.coef.begin(), file.coef.end());
  return {std::move(map), {}};
}

}  // namespace ptm::quantize
