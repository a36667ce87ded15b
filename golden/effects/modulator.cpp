#include "golden/effects/modulator.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "golden/effects/effect.h"
#include "golden/fit/light_solver.h"

namespace ptm::golden {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Node = std::array<double, 2>;

/// Lights at the middles of kRings x kSpokes pieces of equal area.
std::vector<Node> disc_lights() {
  std::vector<Node> nodes;
  for (int i = 0; i < kRings; ++i) {
    const double r = std::sqrt((i + 0.5) / kRings);
    for (int j = 0; j < kSpokes; ++j) {
      // Every second ring is turned, so that no spoke is left out.
      const double angle = 2 * std::numbers::pi * (j + 0.5 * (i % 2)) / kSpokes;
      nodes.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
  }
  return nodes;
}

struct DiscFit {
  std::vector<Node> nodes = disc_lights();
  std::vector<Vector6> basis;    ///< of each node
  std::vector<Vector6> inverse;  ///< of each node: coefficients = sum of value * inverse
  DiscFit() {
    Eigen::Matrix<double, 6, 6> moments = Eigen::Matrix<double, 6, 6>::Zero();
    for (const auto& [lu, lv] : nodes) {
      basis.push_back(light_basis(lu, lv));
      moments += basis.back() * basis.back().transpose();
    }
    const Eigen::LLT<Eigen::Matrix<double, 6, 6>> solver(moments);
    for (const Vector6& b : basis) inverse.push_back(solver.solve(b));
  }
};

struct Residuals {
  double squares = 0, max = 0, count = 0;
};

/// One texel's one channel; a in levels.
Vector6 fit_texel(const DiscFit& fit, const std::vector<Modulator>& factors, std::size_t texel,
                  int channel, Residuals& residuals) {
  std::array<double, kRings * kSpokes> product{};
  Vector6 a = Vector6::Zero();
  for (std::size_t n = 0; n < fit.nodes.size(); ++n) {
    product[n] = 1;
    for (const Modulator& factor : factors) {
      const int c = factor.channels == 1 ? 0 : channel;
      product[n] *= std::clamp(factor.value(texel, c, fit.nodes[n][0], fit.nodes[n][1]), 0.0, 1.0);
    }
    a += product[n] * fit.inverse[n];
  }
  for (std::size_t n = 0; n < fit.nodes.size(); ++n) {
    const double error = std::abs(std::clamp(a.dot(fit.basis[n]), 0.0, 1.0) - product[n]);
    residuals.squares += error * error;
    residuals.max = std::max(residuals.max, error);
    residuals.count += 1;
  }
  return 255 * a;
}

void fit_product(EffectDraw& draw, int channels, std::size_t texels) {
  const DiscFit fit;
  const bool uniform = std::all_of(draw.modulators.begin(), draw.modulators.end(),
                                   [](const Modulator& m) { return m.uniform; });
  Residuals residuals;
  for (int c = 0; c < channels; ++c) {
    std::vector<double>& set = draw.extras.sets.emplace_back();
    set.reserve(texels * 6);
    Vector6 a = Vector6::Zero();
    for (std::size_t t = 0; t < texels; ++t) {
      if (t == 0 || !uniform) a = fit_texel(fit, draw.modulators, t, c, residuals);
      set.insert(set.end(), a.begin(), a.end());
    }
  }
  draw.extras.residual = {std::sqrt(residuals.squares / residuals.count), residuals.max};
  std::ostringstream note;
  note << "the modulator's polynomial is off by " << draw.extras.residual.rms << " RMS and "
       << draw.extras.residual.max << " at most, of 1, over the disc of lights";
  draw.extras.notes.push_back(note.str());
}

}  // namespace

void add_modulator(const EffectSpec& spec, EffectDraw& draw, Modulator modulator) {
  if (draw.extras.passes.empty()) {
    fail_effect(spec, draw, "no specular term to modulate",
                "half-vector or specular-enhancement in the same object");
  }
  draw.modulators.push_back(std::move(modulator));
}

void finish_modulators(EffectDraw& draw) {
  if (draw.modulators.empty()) return;
  int channels = 1;
  for (const Modulator& factor : draw.modulators) channels = std::max(channels, factor.channels);
  const std::size_t before = draw.extras.sets.size();
  if (draw.modulators.size() == 1 && !draw.modulators[0].polynomials.empty()) {
    for (auto& set : draw.modulators[0].polynomials) draw.extras.sets.push_back(std::move(set));
  } else {
    fit_product(draw, channels, draw.map()->texels());
  }
  for (std::size_t s = before; s < draw.extras.sets.size(); ++s) {
    draw.extras.passes.push_back({.set = static_cast<int>(s) + 1, .half = false});
  }
  draw.extras.argument = channels == 3 ? 1 : 0;
}

void modulate_addend(const DrawExtras& extras, std::span<const double> values, Rgb& addend) {
  const bool colored = (extras.argument & 1) != 0;
  for (std::size_t c = 0; c < 3; ++c) addend[c] *= values[colored ? 1 + c : 1] / 255;
}

}  // namespace ptm::golden
