#include "model/reference/fragment.h"

#include <cmath>

#include "model/reference/light_code.h"

namespace ptm::reference {
namespace {

std::optional<Value> coordinate(double u) {
  if (!(std::abs(u) < 256.0)) return std::nullopt;  // false for NaN too
  return static_cast<Value>(std::floor(u * (1 << kCoordinateFrac) + 0.5));
}

}  // namespace

std::optional<Fragment> quantize_fragment(const EvalConfig& config, std::int32_t x, std::int32_t y,
                                          const PlainSample& sample) {
  const auto u = coordinate(sample.u), v = coordinate(sample.v);
  const auto lu = light_code(config, sample.lu), lv = light_code(config, sample.lv);
  if (!u || !v || !lu || !lv) return std::nullopt;
  return Fragment{x, y, *u, *v, *lu, *lv};
}

}  // namespace ptm::reference
