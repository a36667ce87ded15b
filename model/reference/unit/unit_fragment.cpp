#include "model/reference/unit/unit_fragment.h"

#include <algorithm>
#include <cmath>

#include "model/reference/fragment.h"
#include "model/reference/light_code.h"

namespace ptm::reference {
namespace {

constexpr double kOne = 1 << kCoordinateFrac;
constexpr double kCoordinateLimit = 256 * kOne;  ///< Q8.20 with a sign: -2^28 .. 2^28 - 1

std::int32_t fixed(double x) {
  const double nearest = std::floor(x * kOne + 0.5);
  return static_cast<std::int32_t>(std::clamp(nearest, -kCoordinateLimit, kCoordinateLimit - 1));
}

/// Takes whole pairs of periods off where that changes nothing (fmod is exact).
std::int32_t coordinate(Wrap wrap, double u) {
  return fixed(wrap == Wrap::clamp ? u : std::fmod(u, 2.0));
}

bool in_range(const PlainUnitSample& s) {
  constexpr int kPixels = 1 << 14;
  return s.x >= 0 && s.x < kPixels && s.y >= 0 && s.y < kPixels && s.probes_log2 >= 0 &&
         s.probes_log2 <= 4 && s.draw >= 0 && s.draw < kDraws;
}

}  // namespace

std::optional<UnitFragment> quantize_unit_fragment(const EvalConfig& config, const Draw& draw,
                                                   const PlainUnitSample& sample) {
  for (const double number : {sample.u, sample.v, sample.lod, sample.axis_u, sample.axis_v}) {
    if (!std::isfinite(number)) return std::nullopt;
  }
  const auto lu = light_code(config, sample.lu), lv = light_code(config, sample.lv);
  if (!lu || !lv || !in_range(sample)) return std::nullopt;
  UnitFragment out;
  if (sample.hu != 0 || sample.hv != 0) {
    const auto hu = light_code(config, sample.hu), hv = light_code(config, sample.hv);
    if (!hu || !hv) return std::nullopt;
    out.hu = static_cast<std::int32_t>(*hu);
    out.hv = static_cast<std::int32_t>(*hv);
  }
  out.u = coordinate(draw.wrap_u, sample.u);
  out.v = coordinate(draw.wrap_v, sample.v);
  out.axis_u = fixed(sample.axis_u);
  out.axis_v = fixed(sample.axis_v);
  out.lu = static_cast<std::int32_t>(*lu);
  out.lv = static_cast<std::int32_t>(*lv);
  out.x = static_cast<std::uint16_t>(sample.x);
  out.y = static_cast<std::uint16_t>(sample.y);
  out.lod = static_cast<std::uint16_t>(
      std::clamp(std::floor(sample.lod * 256 + 0.5), 0.0, static_cast<double>(4095)));
  out.probes_log2 = static_cast<std::uint8_t>(sample.probes_log2);
  out.draw = static_cast<std::uint8_t>(sample.draw);
  out.lit = sample.lit;
  return out;
}

}  // namespace ptm::reference
