#include "model/reference/unit/shade.h"

#include "model/reference/unit/failed_lines.h"
#include "model/reference/unit/shade_steps.h"

namespace ptm::reference {
namespace {

/// A draw without effects is shaded with nothing but what unit.md asks for: its fields are fewer,
/// and the compiler knows.
struct PlainTrace {
  std::array<Value, kSetField> filtered{};
  std::array<Six<Value>, 3> coef{};
  Three<Value> lit{};
  std::array<Value, 4> color{};
  UnitPixel pixel;
};

template <class Config>
UnitPixel shade_pixel(const Config& config, const UnitState& state, const UnitFragment& fragment) {
  if (has_effects(state.draws[fragment.draw])) [[unlikely]] {
    return shade_trace(config, state, fragment).pixel;
  }
  UnitPixel pixel = shading::shade_with<PlainTrace>(config, state, fragment).pixel;
  pixel.memory_failed = fetches_failed_line(config, state, fragment);
  return pixel;
}

}  // namespace

UnitPixel shade(const EvalConfig& config, const UnitState& state, const UnitFragment& fragment) {
  return with_constant_config(
      config, [&](const auto& constant) { return shade_pixel(constant, state, fragment); });
}

void shade_all(const EvalConfig& config, const UnitState& state,
               std::span<const UnitFragment> fragments, std::span<UnitPixel> pixels) {
  with_constant_config(config, [&](const auto& constant) {
    for (std::size_t i = 0; i < fragments.size(); ++i) {
      pixels[i] = shade_pixel(constant, state, fragments[i]);
    }
  });
}

}  // namespace ptm::reference
