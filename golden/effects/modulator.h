#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace ptm::golden {

struct EffectDraw;
struct EffectSpec;
struct DrawExtras;

/// A factor of the specular term that depends on texel and light: PTM(u, v, lu, lv) of Eq. 15.
struct Modulator {
  int channels = 1;      ///< 1, or 3: red, green, blue
  bool uniform = false;  ///< the same at every texel
  /// At a light (lu, lv) of the closed unit disc: 0 none of the term, 1 all of it. Called from
  /// several threads at once.
  std::function<double(std::size_t texel, int channel, double lu, double lv)> value;
  /// Where it is a polynomial anyway: [channels][texels][6], a0 first, 255 levels for 1.
  std::vector<std::vector<double>> polynomials{};
};

/// How far a fitted modulator is from what it stands for, as shading uses it (limited to 0..1).
struct FitResidual {
  double rms = 0, max = 0;  ///< of 1; over texels, channels and lights
};

/// Adds a factor. Throws InputError without a specular term before it.
void add_modulator(const EffectSpec& spec, EffectDraw& draw, Modulator modulator);

/// The draw's factors become one modulator: "the combination [...] can all be stored in a single
/// PTM" (section 3.7). Adds its sets, one or three, its passes and the argument's bit 0.
///
///     a = argmin of the integral over the disc of (255 product of the factors - L(a))^2 dlu dlv
///
/// by kRings x kSpokes lights of equal areas. A lone factor that is a polynomial is taken as it is.
/// Runs on all cores; the result does not depend on their number.
void finish_modulators(EffectDraw& draw);
inline constexpr int kRings = 16, kSpokes = 16;

/// Effect::texel of every modulator: each channel of the addend times value[1 + c] / 255.
void modulate_addend(const DrawExtras& extras, std::span<const double> values,
                     std::array<double, 3>& addend);

}  // namespace ptm::golden
