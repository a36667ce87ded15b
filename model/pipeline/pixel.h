#pragma once
#include <array>
#include <cstdint>

namespace ptm::pipeline {

/// What the unit gives for one fragment; twin of the output ports of
/// rtl/evaluator/ptm_evaluator.sv.
struct Pixel {
  std::array<std::uint16_t, 3> lum{};  ///< what each channel was made from; LRGB: three times one
  std::array<std::uint8_t, 3> out{};
  bool lum_saturated = false, color_saturated = false;
  bool operator==(const Pixel&) const = default;
};

}  // namespace ptm::pipeline
