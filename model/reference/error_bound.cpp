#include "model/reference/error_bound.h"

#include <cmath>

#include "model/reference/eval_widths.h"
#include "model/reference/rounding.h"

namespace ptm::reference {
namespace {

/// The most that one value of the basis is off, in units of 2^-basis_frac. Of a coarse basis the
/// last code's square may round up to where D2 saturates, which costs the rest of a unit.
double basis_step(const EvalConfig& config, const EvalWidths& width) {
  const int drop = 2 * config.light_frac - config.basis_frac;
  if (drop <= 0) return 0;
  if (config.rounding == Rounding::truncate) return 1;
  const Value last = (Value{1} << (width.light - 1)) - 1;
  const Value square = narrow_constant(config.rounding, last * last, drop);
  return square == sat(square, width.basis) ? 0.5 : 1;
}

}  // namespace

ErrorBound error_bound(const EvalConfig& config, const std::array<double, 6>& a,
                       const std::array<int, 6>& shift, double reach) {
  const double step = config.rounding == Rounding::nearest ? 0.5 : 1;
  const double quadratic = std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]);
  // A light up to the range's end takes the last code, a whole unit below it.
  const double last = std::ldexp(1.0, config.light_int - 1) - std::ldexp(0.5, -config.light_frac);
  const double delta = std::ldexp(reach > last ? 1.0 : 0.5, -config.light_frac);

  ErrorBound bound;
  bound.light = delta * ((std::hypot(2 * a[0], a[2]) + std::hypot(a[2], 2 * a[1])) * reach +
                         std::abs(a[3]) + std::abs(a[4])) +
                delta * delta * quadratic;
  const EvalWidths w = widths(config);
  bound.basis = std::ldexp(basis_step(config, w), -config.basis_frac) * quadratic;
  for (std::size_t i = 0; i < 6; ++i) {
    if (a[i] != 0 && w.frac[i] + shift[i] > config.guard) {
      bound.terms += std::ldexp(step, -config.guard);
    }
  }
  if (config.guard > config.lum_frac) bound.luminance = std::ldexp(step, -config.lum_frac);
  bound.color = step + (config.lum_frac + config.filter_frac > 0 ? step / 255 : 0);
  bound.direct = config.lum_frac > 0 ? step : 0;
  return bound;
}

}  // namespace ptm::reference
