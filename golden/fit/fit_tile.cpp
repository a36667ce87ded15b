#include "golden/fit/fit_tile.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "golden/fit/reweigh.h"

namespace ptm::golden {
namespace {

/// A texel's brightest luminance, in levels, where its colour fills its range: more than samples up
/// to white come to, so that one texel of a float picture far above white does not set the step of
/// all others' coefficients.
constexpr double kMostLuminance = 1020;

constexpr std::size_t kBlock = 256;  ///< texels whose sums stay in the first-level cache

using Lane = std::array<double, kBlock>;  ///< one number a texel

/// Sums over the lights for a block of texels; every fit is made of these alone.
struct Sums {
  std::array<std::array<Lane, 6>, 3> coef;  ///< [signal], inverse * y in levels
  Lane most, sum, squares;                  ///< of y, the luminance
  std::array<Lane, 3> product, average;     ///< sum of rgb * y; sum of rgb
};

/// Lights are added four at a time, so that a sum is loaded and stored once for four samples.
constexpr std::size_t kLights = 4;

/// Red, green and blue of one light; a light that is not there has weight 0 everywhere.
struct LightPlanes {
  std::array<const float*, 3> rgb;
  const double* inverse;  ///< [6]
};
using FourLights = std::array<LightPlanes, kLights>;
using FourLanes = std::array<Lane, kLights>;

// The loops below run four or eight doubles at a time where the machine can; the sums are the same
// to the last bit, as nothing is fused. Sanitizers do not know functions chosen at load time.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define PTM_WIDE [[gnu::target_clones("default", "avx2", "arch=x86-64-v4")]]
#else
#define PTM_WIDE
#endif

PTM_WIDE void mix(const FourLights& lights, const std::array<double, 3>& weights,
                  std::size_t texels, FourLanes& y) {
  for (std::size_t i = 0; i < kLights; ++i) {
    const float *r = lights[i].rgb[0], *g = lights[i].rgb[1], *b = lights[i].rgb[2];
    double* out = y[i].data();
    const auto one = std::find(weights.begin(), weights.end(), 1.0);
    if (one != weights.end()) {  // a channel itself: the others weigh nothing
      const float* only = lights[i].rgb[static_cast<std::size_t>(one - weights.begin())];
      for (std::size_t t = 0; t < texels; ++t) out[t] = double{only[t]};
      continue;
    }
    for (std::size_t t = 0; t < texels; ++t) {
      out[t] = weights[0] * double{r[t]} + weights[1] * double{g[t]} + weights[2] * double{b[t]};
    }
  }
}

PTM_WIDE void add_signal(const FourLanes& y, const FourLights& lights, std::size_t texels,
                         std::array<Lane, 6>& coef) {
  const double *y0 = y[0].data(), *y1 = y[1].data(), *y2 = y[2].data(), *y3 = y[3].data();
  for (std::size_t k = 0; k < 6; ++k) {
    const double p0 = lights[0].inverse[k], p1 = lights[1].inverse[k];
    const double p2 = lights[2].inverse[k], p3 = lights[3].inverse[k];
    double* out = coef[k].data();
    for (std::size_t t = 0; t < texels; ++t) {
      out[t] += (p0 * y0[t] + p1 * y1[t]) + (p2 * y2[t] + p3 * y3[t]);
    }
  }
}

PTM_WIDE void add_luminance(const FourLanes& y, std::size_t texels, Sums& sums) {
  const double *y0 = y[0].data(), *y1 = y[1].data(), *y2 = y[2].data(), *y3 = y[3].data();
  for (std::size_t t = 0; t < texels; ++t) {
    const double most = std::max(std::max(y0[t], y1[t]), std::max(y2[t], y3[t]));
    sums.most[t] = std::max(sums.most[t], most);
    sums.sum[t] += (y0[t] + y1[t]) + (y2[t] + y3[t]);
    sums.squares[t] += (y0[t] * y0[t] + y1[t] * y1[t]) + (y2[t] * y2[t] + y3[t] * y3[t]);
  }
}

PTM_WIDE void add_products(const FourLanes& y, const FourLights& lights, std::size_t channel,
                           std::size_t texels, Lane& sums) {
  const double *y0 = y[0].data(), *y1 = y[1].data(), *y2 = y[2].data(), *y3 = y[3].data();
  const float *c0 = lights[0].rgb[channel], *c1 = lights[1].rgb[channel];
  const float *c2 = lights[2].rgb[channel], *c3 = lights[3].rgb[channel];
  double* out = sums.data();
  for (std::size_t t = 0; t < texels; ++t) {
    out[t] += (double{c0[t]} * y0[t] + double{c1[t]} * y1[t]) +
              (double{c2[t]} * y2[t] + double{c3[t]} * y3[t]);
  }
}

class TileFitter {
 public:
  TileFitter(const PhotoTile& tile, const LightSolver& solver, const FitOptions& options,
             NearTexels near)
      : tile_(tile),
        solver_(solver),
        options_(options),
        lights_(static_cast<std::size_t>(solver.inverse.cols())),
        signals_(fitted_signals(options.kind)),
        near_(near),
        reweigher_(solver) {
    if (near.lights != nullptr) near_solver_.emplace(solver, *near.lights);
  }

  void fit(std::size_t first, std::size_t texels, double* coef, std::uint8_t* color) {
    first_ = first;
    texels_ = texels;
    sums_ = {};
    for (std::size_t i = 0; i < lights_; i += kLights) add_lights(i);
    if (near_solver_ || options_.robust_passes > 0) solve_each();
    for (std::size_t t = 0; t < texels; ++t) {
      double scale = 1;
      if (options_.kind == MapKind::lrgb) scale = take_color(t, color + t * 3);
      if (options_.kind == MapKind::lum) take_chroma(t, color + t * 2);
      for (std::size_t s = 0; s < signals_.size(); ++s) {
        for (std::size_t k = 0; k < 6; ++k) {
          coef[(t * signals_.size() + s) * 6 + k] = scale * sums_.coef[s][k][t];
        }
      }
    }
  }

 private:
  [[nodiscard]] std::array<const float*, 3> rgb(std::size_t light) const {
    const auto plane = [&](std::size_t c) { return tile_.plane(light, c) + first_; };
    return {plane(0), plane(1), plane(2)};
  }

  [[nodiscard]] FourLights four(std::size_t first) const {
    static constexpr std::array<float, kBlock> dark{};
    static constexpr std::array<double, 6> nothing{};
    FourLights lights;
    for (std::size_t i = 0; i < kLights; ++i) {
      if (first + i < lights_) {
        lights[i] = {rgb(first + i), solver_.inverse.data() + (first + i) * 6};  // column-major
      } else {
        lights[i] = {{dark.data(), dark.data(), dark.data()}, nothing.data()};
      }
    }
    return lights;
  }

  void add_lights(std::size_t first) {
    const FourLights lights = four(first);
    for (std::size_t s = 0; s < signals_.size(); ++s) {
      mix(lights, signals_[s], texels_, y_);
      add_signal(y_, lights, texels_, sums_.coef[s]);
    }
    if (options_.kind == MapKind::rgb) return;
    add_luminance(y_, texels_, sums_);
    const bool products =
        options_.kind == MapKind::lrgb && options_.color == ColorRule::least_squares;
    if (!products) {
      for (Lane& lane : y_) lane.fill(1);
    }
    for (std::size_t c = 0; c < 3; ++c) {
      add_products(y_, lights, c, texels_, products ? sums_.product[c] : sums_.average[c]);
    }
  }

  /// Texel by texel: the fit under near lights, and robust passes.
  void solve_each() {
    Eigen::VectorXd samples(static_cast<Eigen::Index>(lights_));
    std::array<double, 6> a{};
    for (std::size_t t = 0; t < texels_; ++t) {
      if (near_solver_) {
        near_solver_->look(near_.first + first_ + t);
        if (options_.robust_passes > 0) reweigher_.take_design(near_solver_->design());
      }
      for (std::size_t s = 0; s < signals_.size(); ++s) {
        take_samples(t, signals_[s], samples);
        for (std::size_t k = 0; k < 6; ++k) a[k] = sums_.coef[s][k][t];
        if (near_solver_)
          Eigen::Map<Eigen::Matrix<double, 6, 1>>(a.data()) = near_solver_->solve(samples);
        if (options_.robust_passes > 0)
          reweigher_.improve({samples.data(), lights_}, a, options_.robust_passes);
        for (std::size_t k = 0; k < 6; ++k) sums_.coef[s][k][t] = a[k];
      }
      if (options_.robust_passes > 0 && options_.kind != MapKind::rgb)
        reweigh_color(t, {samples.data(), lights_});
    }
  }

  void take_samples(std::size_t t, const std::array<double, 3>& weights,
                    Eigen::VectorXd& samples) const {
    for (std::size_t i = 0; i < lights_; ++i) {
      const auto planes = rgb(i);
      double y = 0;
      for (std::size_t c = 0; c < 3; ++c) y += weights[c] * double{planes[c][t]};
      samples[static_cast<Eigen::Index>(i)] = y;
    }
  }

  /// The sums behind the colour again, each light by its last weight.
  void reweigh_color(std::size_t t, std::span<const double> y) {
    sums_.sum[t] = sums_.squares[t] = 0;
    std::array<double, 3> product{}, average{};
    double weights = 0;
    for (std::size_t i = 0; i < lights_; ++i) {
      const double w = reweigher_.weights()[static_cast<Eigen::Index>(i)];
      const auto planes = rgb(i);
      weights += w;
      sums_.sum[t] += w * y[i];
      sums_.squares[t] += w * y[i] * y[i];
      for (std::size_t c = 0; c < 3; ++c) {
        product[c] += w * double{planes[c][t]} * y[i];
        average[c] += w * double{planes[c][t]};
      }
    }
    const double back = static_cast<double>(lights_) / weights;  // sums of as many lights as before
    sums_.sum[t] *= back;
    for (std::size_t c = 0; c < 3; ++c) {
      sums_.product[c][t] = product[c];
      sums_.average[c][t] = average[c] * back;
    }
  }

  [[nodiscard]] std::uint8_t to_byte(double level) const {
    const double half = options_.truncate_color ? 0 : 0.5;
    return static_cast<std::uint8_t>(std::floor(std::clamp(level, 0.0, 255.0) + half));
  }

  /// Writes an LRGB texel's colour; returns what its coefficients are to be multiplied by.
  double take_color(std::size_t t, std::uint8_t* color) const {
    const double most = sums_.most[t];
    if (!(most > 0)) {
      std::fill_n(color, 3, std::uint8_t{0});
      return 0;
    }
    const bool average = options_.color == ColorRule::average;
    const auto& sums = average ? sums_.average : sums_.product;
    const double of_luminance = average ? sums_.sum[t] : sums_.squares[t];
    const double brightest = 255 * of_luminance / std::max({sums[0][t], sums[1][t], sums[2][t]});
    double k = std::max(brightest, most * 255 / kMostLuminance);
    if (options_.full_range == FullRange::luminance) k = average ? std::min(most, brightest) : most;
    for (std::size_t c = 0; c < 3; ++c) color[c] = to_byte(k * sums[c][t] / of_luminance);
    return 255 / k;
  }

  /// Cr and Cb of the average photograph (JFIF 1.02).
  void take_chroma(std::size_t t, std::uint8_t* color) const {
    const double lights = static_cast<double>(lights_), y = sums_.sum[t] / lights;
    color[0] = to_byte(128 + (sums_.average[0][t] / lights - y) / 1.402);
    color[1] = to_byte(128 + (sums_.average[2][t] / lights - y) / 1.772);
  }

  const PhotoTile& tile_;
  const LightSolver& solver_;
  FitOptions options_;
  std::size_t lights_, first_ = 0, texels_ = 0;
  std::vector<std::array<double, 3>> signals_;
  NearTexels near_;
  std::optional<NearSolver> near_solver_;
  Reweigher reweigher_;
  Sums sums_{};
  FourLanes y_{};
};

/// The photographs as if each light were as strong everywhere as in the picture's centre.
PhotoTile without_falloff(const PhotoTile& tile, const NearTexels& near, std::vector<float>& even) {
  even.resize(near.lights->size() * 3 * tile.texels);
  for (std::size_t i = 0; i < near.lights->size(); ++i) {
    for (std::size_t t = 0; t < tile.texels; ++t) {
      const double falloff = near.lights->at(i, near.first + t).falloff;
      for (std::size_t c = 0; c < 3; ++c) {
        even[(i * 3 + c) * tile.texels + t] =
            static_cast<float>(double{tile.plane(i, c)[t]} / falloff);
      }
    }
  }
  return {tile.texels, tile.texels, even.data()};
}

}  // namespace

std::vector<std::array<double, 3>> fitted_signals(MapKind kind) {
  if (kind == MapKind::lrgb) return {kLumaWeights};
  if (kind == MapKind::lum) return {{0.299, 0.587, 0.114}};
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
}

void fit_tile(const PhotoTile& tile, const LightSolver& solver, const FitOptions& options,
              std::span<double> coef, std::span<std::uint8_t> color, NearTexels near) {
  PtmMap shape;
  shape.kind = options.kind;
  if (coef.size() != tile.texels * 6 * shape.polynomials() ||
      color.size() != tile.texels * shape.color_bytes()) {
    throw std::invalid_argument("a tile of a fit whose sizes do not agree");
  }
  std::vector<float> even;
  const PhotoTile lit = near.lights == nullptr ? tile : without_falloff(tile, near, even);
  TileFitter fitter(lit, solver, options, near);
  for (std::size_t first = 0; first < tile.texels; first += kBlock) {
    fitter.fit(first, std::min(kBlock, tile.texels - first),
               coef.data() + first * 6 * shape.polynomials(),
               color.data() + first * shape.color_bytes());
  }
}

}  // namespace ptm::golden
