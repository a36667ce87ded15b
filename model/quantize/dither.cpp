#include "model/quantize/dither.h"

#include <algorithm>
#include <cmath>

#include "model/quantize/quantize.h"

namespace ptm::quantize {
namespace {

using reference::EvalConfig;

/// The Bayer matrix' value at a texel, (k + 1/2) / 64 with k = 0..63: the bits of x ^ y and y
/// interleaved, the lowest bit of the place being the highest of the value.
double bayer(std::size_t x, std::size_t y) {
  unsigned k = 0;
  for (int bit = 0; bit < 3; ++bit) {
    const auto turned = static_cast<unsigned>(((x ^ y) >> bit) & 1U);
    k = k << 2 | turned << 1 | static_cast<unsigned>((y >> bit) & 1U);
  }
  return (k + 0.5) / 64;
}

/// Rounds the six coefficients of one polynomial together.
class PlaneRounder {
 public:
  PlaneRounder(const Grid& grid, const EvalConfig& config, const Gram& gram)
      : factor_(gram_factor(gram)) {
    for (std::size_t i = 0; i < kSix; ++i) {
      window_[i] = delta_window(config, grid.bias[i]);
      up_[i] = std::ldexp(1.0, grid.shift[i]);
    }
  }

  struct Result {
    Six<int> delta{};
    Six<double> left{};  ///< wanted less stored
    Six<bool> saturated{};
  };

  [[nodiscard]] Result round(const Six<double>& wanted, const Six<double>& threshold) const {
    Result result;
    for (std::size_t i = kSix; i-- > 0;) {
      double target = wanted[i];
      for (std::size_t j = i + 1; j < kSix; ++j) {
        target += entry(i, j) / entry(i, i) * result.left[j];
      }
      const double rounded = std::floor(target * up_[i] + threshold[i]);
      const double delta = std::clamp(rounded, double(window_[i].low), double(window_[i].high));
      result.saturated[i] = delta != rounded;
      result.delta[i] = static_cast<int>(delta);
      result.left[i] = std::clamp(wanted[i] - delta / up_[i], -1e100, 1e100);
    }
    return result;
  }

 private:
  [[nodiscard]] double entry(std::size_t i, std::size_t j) const {
    return factor_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }

  Gram factor_;
  Six<Window> window_;
  Six<double> up_{};
};

Six<double> thresholds(Dither dither, std::size_t x, std::size_t y) {
  constexpr double golden_section = 0.6180339887498949;
  Six<double> threshold;
  threshold.fill(0.5);
  if (dither != Dither::ordered) return threshold;
  for (std::size_t i = 0; i < kSix; ++i) {
    const double turned = bayer(x, y) + static_cast<double>(i) * golden_section;
    threshold[i] = turned - std::floor(turned);
  }
  return threshold;
}

/// Errors on their way to the rest of a row and to the row below, one cell more at either end.
class Diffusion {
 public:
  Diffusion(std::size_t width, std::size_t polynomials)
      : polynomials_(polynomials),
        here_((width + 2) * polynomials, Six<double>{}),
        below_(here_.size(), Six<double>{}) {}

  void next_row() {
    here_.swap(below_);
    std::fill(below_.begin(), below_.end(), Six<double>{});
  }
  [[nodiscard]] const Six<double>& at(std::size_t x, std::size_t p) const {
    return here_[(x + 1) * polynomials_ + p];
  }
  void spread(std::size_t x, std::size_t p, const Six<double>& left) {
    const std::size_t cell = (x + 1) * polynomials_ + p;
    for (std::size_t i = 0; i < kSix; ++i) {
      here_[cell + polynomials_][i] += left[i] * 7 / 16;
      below_[cell - polynomials_][i] += left[i] * 3 / 16;
      below_[cell][i] += left[i] * 5 / 16;
      below_[cell + polynomials_][i] += left[i] / 16;
    }
  }

 private:
  std::size_t polynomials_;
  std::vector<Six<double>> here_, below_;
};

}  // namespace

StoredMap quantize_dithered(const RealMap& real, const Grid& grid, const EvalConfig& config,
                            Dither dither, const Gram& gram) {
  StoredMap stored = quantize_on_grid(real, grid, config, Method::nearest_plane, gram);
  if (dither == Dither::none) return stored;
  stored.dither = dither;
  stored.saturated = {};
  const PlaneRounder rounder(grid, config, gram);
  const auto width = static_cast<std::size_t>(real.width);
  const auto polynomials = static_cast<std::size_t>(real.polynomials);
  Diffusion diffusion(width, polynomials);
  for (std::size_t k = 0; k < real.coef.size(); k += kSix) {
    const std::size_t p = k / kSix % polynomials, texel = k / kSix / polynomials;
    const std::size_t x = texel % width, y = texel / width;
    if (x == 0 && p == 0) diffusion.next_row();
    Six<double> wanted = diffusion.at(x, p);
    for (std::size_t i = 0; i < kSix; ++i) wanted[i] += real.coef[k + i];
    const PlaneRounder::Result result = rounder.round(wanted, thresholds(dither, x, y));
    bool saturated = false;
    for (std::size_t i = 0; i < kSix; ++i) {
      stored.coef[k + i] = static_cast<std::uint16_t>(result.delta[i] + grid.bias[i]);
      stored.saturated[i] += result.saturated[i] ? 1U : 0U;
      saturated = saturated || result.saturated[i];
    }
    if (dither == Dither::diffused && !saturated) diffusion.spread(x, p, result.left);
  }
  record_loss(real, gram, stored);
  return stored;
}

}  // namespace ptm::quantize
