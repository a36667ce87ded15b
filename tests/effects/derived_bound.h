#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "golden/render/unit_picture.h"
#include "model/quantize/gram.h"
#include "model/reference/unit/shade.h"
#include "testbench/run/unit_job.h"

/// How far the hardware's pixel may lie from golden's, derived from the bits: what the stored
/// coefficients and the light's codes change is computed exactly from them, and every rounding adds
/// what its fraction bits say. For texels sampled alone (no filter), of draws that are not combined
/// or combined by replace, modulate or blend.
namespace ptm::testbench {

struct Interval {
  double lo = 0, hi = 0;
  [[nodiscard]] bool holds(double x) const { return lo <= x && x <= hi; }
};

inline double polynomial(const std::array<double, 6>& a, double u, double v) {
  return a[0] * u * u + a[1] * v * v + a[2] * u * v + a[3] * u + a[4] * v + a[5];
}
inline double clamped(double x) { return std::clamp(x, 0.0, 255.0); }

class DerivedBound {
 public:
  DerivedBound(const UnitJob& job, const golden::SurfaceSample& sample,
               const reference::UnitFragment& fragment)
      : job_(job),
        config_(job.config),
        sample_(sample),
        fragment_(fragment),
        draw_(job.state.draws[static_cast<std::size_t>(sample.draw)]),
        spec_(job.scene.draws[static_cast<std::size_t>(sample.draw)]),
        extras_(job.extras[static_cast<std::size_t>(sample.draw)]),
        trace_(reference::shade_trace(job.config, job.state, fragment)) {
    if (spec_.map < 0) return;
    const golden::LoadedTexture& map = job.textures[static_cast<std::size_t>(spec_.map)];
    const auto at = reference::make_footprint(draw_, fragment, 0, 0, 0);
    texel_ = static_cast<std::size_t>(at.j0) * static_cast<std::size_t>(map.width) +
             static_cast<std::size_t>(at.i0);
  }

  /// Why what the hardware evaluates is not what golden does but for rounding to the bits that
  /// there are: empty if it is. Light codes lie within half a code of the light; stored
  /// coefficients are those to which the nearest-plane rule rounds the real ones, or are the last
  /// of the grid; colours are the texel's own. So a wrong texel, plane, grid or light is found
  /// here.
  [[nodiscard]] std::string wrong_input() const {
    if (spec_.map < 0) return {};
    const bool half = std::any_of(extras_.passes.begin(), extras_.passes.end(),
                                  [](const auto& pass) { return pass.half; });
    if (!is_code(fragment_.lu, sample_.light_vertex[0]) ||
        !is_code(fragment_.lv, sample_.light_vertex[1])) {
      return "the light's code";
    }
    if (half && (!is_code(fragment_.hu, sample_.half_vertex[0]) ||
                 !is_code(fragment_.hv, sample_.half_vertex[1]))) {
      return "the half-vector's code";
    }
    const golden::LoadedTexture& map = job_.textures[static_cast<std::size_t>(spec_.map)];
    const auto polynomials = static_cast<std::size_t>(map.polynomials);
    for (std::size_t p = 0; p < polynomials; ++p) {
      if (!is_rounded(&map.coef[(texel_ * polynomials + p) * 6], 6 * p, draw_.bias, draw_.shift)) {
        return "polynomial " + std::to_string(p);
      }
    }
    for (std::size_t s = 0; s < extras_.sets.size(); ++s) {
      if (!is_rounded(&extras_.sets[s][texel_ * 6], 26 + 6 * s, draw_.effects.bias[s],
                      draw_.effects.shift[s])) {
        return "set " + std::to_string(s);
      }
    }
    for (std::size_t c = 0; polynomials == 1 && c < 3; ++c) {
      if (trace_.filtered[reference::kMapColorField + c] != map.color[texel_ * 3 + c]) {
        return "the colour";
      }
    }
    return {};
  }

  /// Where channel c of the hardware's pixel lies.
  [[nodiscard]] Interval channel(std::size_t c) const {
    Interval out = combined(c);
    if ((draw_.effects.stages & 1U) != 0) {
      const Interval more = addend(c);
      out = {out.lo + more.lo - step(1), out.hi + more.hi + step(1)};
    }
    return {std::min(out.lo, 255.0), std::min(out.hi, 255.0)};
  }

 private:
  /// The nearest code, or the last one for a light up to the limit that has none of its own.
  [[nodiscard]] bool is_code(std::int32_t code, double light) const {
    const std::int32_t last = (1 << (config_.light_int - 1 + config_.light_frac)) - 1;
    if (std::abs(code) == last && std::abs(light) <= std::ldexp(1.0, config_.light_int - 1)) {
      return light * code > 0 && std::abs(light) > std::ldexp(last - 0.5, -config_.light_frac);
    }
    return std::abs(std::ldexp(code, -config_.light_frac) - light) <=
           std::ldexp(1.0, -config_.light_frac - 1) + 1e-12;
  }

  /// docs/spec/quantize.md, the nearest-plane rule, from a5 down to a0. A coefficient at an end of
  /// its grid may lie beyond it.
  [[nodiscard]] bool is_rounded(const double* real, std::size_t first,
                                const reference::Six<reference::Value>& bias,
                                const reference::Six<reference::Value>& shift) const {
    static const quantize::Gram r = quantize::gram_factor(quantize::hemisphere_gram());
    const std::array<double, 6> held = stored(first, bias, shift);
    const reference::Value last = (1 << config_.coef_bits) - 1;
    for (Eigen::Index i = 5; i >= 0; --i) {
      const auto n = static_cast<std::size_t>(i);
      double target = real[n];
      for (Eigen::Index j = i + 1; j < 6; ++j) {
        const auto m = static_cast<std::size_t>(j);
        target -= r(i, j) / r(i, i) * (held[m] - real[m]);
      }
      const double grain = std::ldexp(1.0, -static_cast<int>(shift[n]));
      const reference::Value code = trace_.filtered[first + n];
      const bool low = code == 0 && target < held[n], high = code == last && target > held[n];
      if (!low && !high && std::abs(held[n] - target) > grain / 2 + 1e-9) return false;
    }
    return true;
  }

  /// The most that one rounding to a unit errs.
  [[nodiscard]] double step(double unit) const {
    return config_.rounding == reference::Rounding::nearest ? unit / 2 : unit;
  }
  [[nodiscard]] static double unit(int bits) { return std::ldexp(1.0, -bits); }

  /// D2, D4 and D6 of a polynomial with coefficients q.
  [[nodiscard]] double evaluation_error(const std::array<double, 6>& q) const {
    const double basis = std::abs(q[0]) + std::abs(q[1]) + std::abs(q[2]);
    return basis * step(unit(config_.basis_frac)) + 6 * step(unit(config_.guard)) +
           step(unit(config_.lum_frac));
  }

  /// A stored polynomial as D1 and D4 read it; `first` is its field.
  [[nodiscard]] std::array<double, 6> stored(std::size_t first,
                                             const reference::Six<reference::Value>& bias,
                                             const reference::Six<reference::Value>& shift) const {
    std::array<double, 6> q{};
    const int top = 1 << (config_.delta_bits - 1);
    for (std::size_t i = 0; i < 6; ++i) {
      const int delta =
          std::clamp(static_cast<int>(trace_.filtered[first + i] - bias[i]), -top, top - 1);
      q[i] = std::ldexp(delta, -static_cast<int>(shift[i]));
    }
    return q;
  }

  /// Around golden's polynomial a at (u, v): the stored one q at the codes (cu, cv), evaluated.
  struct Luminance {
    double right = 0, stored = 0, error = 0;
  };
  [[nodiscard]] Luminance luminance(const std::array<double, 6>& a, const std::array<double, 6>& q,
                                    bool half) const {
    const auto& light = half ? sample_.half_vertex : sample_.light_vertex;
    const double cu = std::ldexp(half ? fragment_.hu : fragment_.lu, -config_.light_frac);
    const double cv = std::ldexp(half ? fragment_.hv : fragment_.lv, -config_.light_frac);
    return {polynomial(a, light[0], light[1]), polynomial(q, cu, cv), evaluation_error(q)};
  }

  [[nodiscard]] static std::array<double, 6> six(const double* a) {
    return {a[0], a[1], a[2], a[3], a[4], a[5]};
  }

  /// P of channel c, around golden's.
  [[nodiscard]] Interval lit(std::size_t c) const {
    if (spec_.map < 0 || !fragment_.lit) return {0, 0};
    const golden::LoadedTexture& map = job_.textures[static_cast<std::size_t>(spec_.map)];
    const bool rgb = map.polynomials == 3;
    const std::size_t p = rgb ? c : 0;
    const std::array<double, 6> a =
        six(&map.coef[(texel_ * static_cast<std::size_t>(map.polynomials) + p) * 6]);
    const Luminance l = luminance(a, stored(6 * p, draw_.bias, draw_.shift), false);
    double right = l.right, held = l.stored, error = l.error + step(1);
    if (!rgb) {
      const double color = map.color[texel_ * 3 + c] / 255.0;
      const double held_color =
          static_cast<double>(trace_.filtered[reference::kMapColorField + c]) / 255;
      right *= color;
      const double top = std::ldexp(1.0, config_.lum_bits) - unit(config_.lum_frac);  // D6's
      held = std::clamp(held, 0.0, top) * held_color;
      error = l.error * held_color + step(1) + step(1) / 255;
    }
    const double most = std::abs(clamped(right) - clamped(held)) + error;
    return {clamped(right) - most, clamped(right) + most};
  }

  [[nodiscard]] Interval combined(std::size_t c) const {
    const Interval p = lit(c);
    if (draw_.combine == reference::Combine::none) return p;
    const golden::LoadedTexture& color = job_.textures[static_cast<std::size_t>(spec_.color)];
    const auto at = reference::make_footprint(draw_, fragment_, 1, 0, 0);
    const std::size_t t = static_cast<std::size_t>(at.j0) * static_cast<std::size_t>(color.width) +
                          static_cast<std::size_t>(at.i0);
    const Interval texture{color.rgba[t * 4 + c] - 0.5, color.rgba[t * 4 + c] + 0.5};
    if (draw_.combine == reference::Combine::replace) return texture;
    if (draw_.combine == reference::Combine::modulate) {
      return {p.lo * std::max(texture.lo, 0.0) / 255 - step(1), p.hi * texture.hi / 255 + step(1)};
    }
    if (draw_.combine != reference::Combine::blend) throw std::logic_error("no bound is derived");
    const double ka = spec_.ka, kd = spec_.kd, weight = unit(9) * 2 * 255;  // two weights' rounding
    return {ka * texture.lo + kd * p.lo - weight - step(1),
            ka * texture.hi + kd * p.hi + weight + step(1)};
  }

  /// value[k] around golden's, levels.
  [[nodiscard]] Interval value(std::size_t k) const {
    const golden::EffectPass& pass = extras_.passes[k];
    const golden::LoadedTexture& map = job_.textures[static_cast<std::size_t>(spec_.map)];
    const auto s = static_cast<std::size_t>(pass.set);
    const double* a = s == 0 ? &map.coef[texel_ * 6] : &extras_.sets[s - 1][texel_ * 6];
    const auto q = s == 0
                       ? stored(0, draw_.bias, draw_.shift)
                       : stored(20 + 6 * s, draw_.effects.bias[s - 1], draw_.effects.shift[s - 1]);
    const Luminance l = luminance(six(a), q, pass.half);
    const double most = std::abs(clamped(l.right) - clamped(l.stored)) + l.error;
    return {clamped(clamped(l.right) - most), clamped(clamped(l.right) + most)};
  }

  /// X2 and X3; the power of whole levels where lum_frac is 0, of the knots around where it is not.
  [[nodiscard]] Interval addend(std::size_t c) const {
    if (!fragment_.lit || extras_.passes.empty()) return {0, 0};
    const double sixteenth = step(1.0 / 16), weight = unit(9) * 255;
    const auto power = [&](double x) { return 255 * std::pow(x / 255, extras_.exponent); };
    const Interval x = value(0);
    Interval s{extras_.ks * (power(std::floor(x.lo)) - 1.0 / 32 - sixteenth) - weight - sixteenth,
               extras_.ks * (power(std::ceil(x.hi)) + 1.0 / 32 + sixteenth) + weight + sixteenth};
    s.lo = std::max(s.lo, 0.0);
    if ((draw_.effects.stages & 2U) == 0) return s;
    const Interval m = value((draw_.effects.argument & 1U) != 0 ? 1 + c : 1);
    const auto part = [&](double level) { return std::clamp(level / 255, 0.0, 1.0); };
    const double off = 1.0 / 512;  // m + (m >> 7) for m
    return {s.lo * std::max(0.0, part(m.lo - step(1)) - off) - sixteenth,
            s.hi * (part(m.hi + step(1)) + off) + sixteenth};
  }

  const UnitJob& job_;
  const reference::EvalConfig& config_;
  const golden::SurfaceSample& sample_;
  const reference::UnitFragment& fragment_;
  const reference::Draw& draw_;
  const golden::DrawSpec& spec_;
  const golden::DrawExtras& extras_;
  reference::ShadeTrace trace_;
  std::size_t texel_ = 0;
};

}  // namespace ptm::testbench
