#pragma once
#include <random>

#include "model/reference/evaluate.h"

namespace ptm::tests {

/// Any configuration in the ranges that datapath.md states, ends included often.
inline reference::EvalConfig random_config(std::mt19937_64& rng) {
  const auto in = [&](int low, int high) {
    switch (rng() % 4) {
      case 0:
        return low;
      case 1:
        return high;
      default:
        return std::uniform_int_distribution(low, high)(rng);
    }
  };
  reference::EvalConfig c;
  c.coef_bits = in(4, 12);
  c.delta_bits = in(5, 13);
  c.light_int = in(1, 3);
  c.light_frac = in(4, 14);
  c.basis_frac = in(4, 2 * c.light_frac);
  c.guard = in(0, 12);
  c.rounding = rng() % 2 != 0 ? reference::Rounding::nearest : reference::Rounding::truncate;
  c.lum_bits = in(8, 12);
  c.lum_frac = in(0, 4);
  c.shift_min = in(-8, 0);
  c.shift_groups = rng() % 2 != 0 ? 6 : 3;
  c.filter_frac = in(0, 4);
  return c;
}

/// Operands from the whole legal range, extremes often.
inline reference::LrgbOperands<> random_operands(std::mt19937_64& rng,
                                                 const reference::EvalConfig& c) {
  const auto in = [&](reference::Value low, reference::Value high) {
    const auto pick = rng() % 8;
    if (pick == 0) return low;
    if (pick == 1) return high;
    return std::uniform_int_distribution<reference::Value>(low, high)(rng);
  };
  reference::LrgbOperands<> o;
  const reference::Value light = reference::Value{1} << (c.light_int + c.light_frac - 1);
  for (unsigned i = 0; i < 6; ++i) {
    o.coef[i] = in(0, (reference::Value{1} << (c.coef_bits + c.filter_frac)) - 1);
    o.bias[i] = in(0, (reference::Value{1} << c.coef_bits) - 1);
    o.shift[i] = in(c.shift_min, reference::kShiftMax);
  }
  for (auto& channel : o.rgb) channel = in(0, 255 << c.filter_frac);
  o.lu = in(-light, light - 1);
  o.lv = in(-light, light - 1);
  return o;
}

}  // namespace ptm::tests
