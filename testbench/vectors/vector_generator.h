#pragma once
#include <cstdint>

#include "model/reference/evaluate.h"

/// Operands for tests and for `ptmsim vectors`: vector i of seed s is a pure function of
/// (s, i, config), so that any part of a set can be made anywhere, and a failure names its vector.
///
/// Every field comes from its whole legal range. A quarter of the fields are corners of it: the
/// ends, 0, and powers of two of either sign and their neighbours; one vector in eight is made of
/// corners alone, and one in four has shifts under which luminance seldom saturates. With
/// shift_groups = 3 the shifts of a group are equal.
namespace ptm::testbench {

[[nodiscard]] reference::LrgbOperands<> lrgb_vector(const reference::EvalConfig& config,
                                                    std::uint64_t seed, std::uint64_t index);
[[nodiscard]] reference::RgbOperands<> rgb_vector(const reference::EvalConfig& config,
                                                  std::uint64_t seed, std::uint64_t index);

/// a and b of coef_bits + filter_frac bits, f of 8.
struct LerpOperands {
  reference::Value a = 0, b = 0, f = 0;
};
[[nodiscard]] LerpOperands lerp_vector(const reference::EvalConfig& config, std::uint64_t seed,
                                       std::uint64_t index);

}  // namespace ptm::testbench
