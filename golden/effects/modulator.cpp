#include "golden/effects/modulator.h"

#include <tbb/parallel_for.h>

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

using Product = std::array<double, kRings * kSpokes>;

/// A factor at every light, channel by channel.
std::vector<double> at_lights(const DiscFit& fit, const Modulator& factor, std::size_t texel) {
  std::vector<double> values;
  values.reserve(fit.nodes.size() * static_cast<std::size_t>(factor.channels));
  for (int c = 0; c < factor.channels; ++c) {
    for (const auto& [lu, lv] : fit.nodes) {
      values.push_back(std::clamp(factor.value(texel, c, lu, lv), 0.0, 1.0));
    }
  }
  return values;
}

/// a in levels.
Vector6 fit_values(const DiscFit& fit, const Product& product, Residuals& residuals) {
  Vector6 a = Vector6::Zero();
  for (std::size_t n = 0; n < fit.nodes.size(); ++n) a += product[n] * fit.inverse[n];
  for (std::size_t n = 0; n < fit.nodes.size(); ++n) {
    const double error = std::abs(std::clamp(a.dot(fit.basis[n]), 0.0, 1.0) - product[n]);
    residuals.squares += error * error;
    residuals.max = std::max(residuals.max, error);
    residuals.count += 1;
  }
  return 255 * a;
}

/// The factors of a draw; those that are the same at every texel are computed once.
class Factors {
 public:
  Factors(const DiscFit& fit, const std::vector<Modulator>& factors) : fit_(fit) {
    for (const Modulator& factor : factors) {
      factors_.push_back({&factor, factor.uniform ? at_lights(fit, factor, 0) : Values{}});
    }
  }
  /// One texel's polynomials, one a set.
  void fit_texel(std::size_t texel, std::vector<std::vector<double>>& sets,
                 Residuals& residuals) const {
    std::vector<Values> here(factors_.size());
    for (std::size_t f = 0; f < factors_.size(); ++f) {
      if (!factors_[f].modulator->uniform) {
        here[f] = at_lights(fit_, *factors_[f].modulator, texel);
      }
    }
    for (std::size_t c = 0; c < sets.size(); ++c) {
      Product product;
      product.fill(1);
      for (std::size_t f = 0; f < factors_.size(); ++f) {
        const auto& [modulator, uniform] = factors_[f];
        const Values& values = modulator->uniform ? uniform : here[f];
        const std::size_t first = modulator->channels == 1 ? 0 : c * product.size();
        for (std::size_t n = 0; n < product.size(); ++n) product[n] *= values[first + n];
      }
      const Vector6 a = fit_values(fit_, product, residuals);
      std::copy(a.begin(), a.end(), sets[c].begin() + static_cast<std::ptrdiff_t>(texel * 6));
    }
  }

 private:
  using Values = std::vector<double>;
  struct Factor {
    const Modulator* modulator;
    Values uniform;  ///< at_lights(), empty if texels differ
  };
  const DiscFit& fit_;
  std::vector<Factor> factors_;
};

/// Fits every texel, or the first and copies it. Runs on all cores; the sums are taken in the order
/// of rows, so that the result does not depend on their number.
Residuals fit_texels(const LoadedTexture& map, const std::vector<Modulator>& modulators,
                     std::vector<std::vector<double>>& sets) {
  const DiscFit fit;
  const Factors factors(fit, modulators);
  for (auto& set : sets) set.resize(map.texels() * 6);
  Residuals all;
  if (std::all_of(modulators.begin(), modulators.end(),
                  [](const Modulator& m) { return m.uniform; })) {
    factors.fit_texel(0, sets, all);
    for (auto& set : sets) {
      for (std::size_t k = 6; k < set.size(); ++k) set[k] = set[k - 6];
    }
    return all;
  }
  const auto width = static_cast<std::size_t>(map.width);
  std::vector<Residuals> rows(static_cast<std::size_t>(map.height));
  tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t row) {
    for (std::size_t x = 0; x < width; ++x) factors.fit_texel(row * width + x, sets, rows[row]);
  });
  for (const Residuals& row : rows) {
    all.squares += row.squares;
    all.max = std::max(all.max, row.max);
    all.count += row.count;
  }
  return all;
}

void fit_product(EffectDraw& draw, int channels) {
  std::vector<std::vector<double>> sets(static_cast<std::size_t>(channels));
  const Residuals residuals = fit_texels(*draw.map(), draw.modulators, sets);
  for (auto& set : sets) draw.extras.sets.push_back(std::move(set));
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
    fit_product(draw, channels);
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
