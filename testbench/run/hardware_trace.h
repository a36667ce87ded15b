#pragma once
#include <array>
#include <string>
#include <vector>

#include "model/reference/evaluate.h"
#include "testbench/run/run_result.h"

/// Intermediate values by name, as the worst-pixel table and the RTL's taps give them.
namespace ptm::testbench {

/// Names as in docs/spec/datapath.md: coef0.., bias0.., shift0.., d0.., uu, vv, uv, p0.., t0..,
/// acc, lum, lum_saturated, product_r.., out_r.., color_saturated; the channel of an RGB map's pass
/// goes in front: "r.acc".
struct IntegerValue {
  std::string name;
  reference::Value code = 0;
  bool operator==(const IntegerValue&) const = default;
};

[[nodiscard]] std::vector<IntegerValue> operand_values(const reference::LrgbOperands<>& in);
[[nodiscard]] std::vector<IntegerValue> operand_values(const reference::RgbOperands<>& in);
[[nodiscard]] std::vector<IntegerValue> trace_values(
    const reference::LrgbTrace<reference::Value>& trace);
[[nodiscard]] std::vector<IntegerValue> trace_values(
    const reference::RgbTrace<reference::Value>& trace);

/// Prints a value as its code and, where its unit is not 1, the real number it stands for:
/// "64 (0.25)". Coefficients, products, terms, sum and luminance are in levels.
[[nodiscard]] NamedValue print_value(const IntegerValue& value, const reference::EvalConfig& config,
                                     const std::array<reference::Value, 6>& shift);

}  // namespace ptm::testbench
