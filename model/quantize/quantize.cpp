#include "model/quantize/quantize.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "model/quantize/choose_grid.h"
#include "model/quantize/lanes.h"

namespace ptm::quantize {
namespace {

using reference::EvalConfig;

/// stored - real, limited so that its square stays finite for any finite coefficient.
double difference(double stored, double real) { return std::clamp(stored - real, -1e100, 1e100); }

/// Polynomials stored together where the grid is given: their lanes stay in the first-level cache.
constexpr std::size_t kBlock = 256;

/// The six coefficients of all polynomials of a map, stored one after the other from a5 down.
class Rounder {
 public:
  Rounder(const RealMap& real, const EvalConfig& config, Method method, const Gram& gram)
      : real_(real), config_(config), nearest_plane_(method != Method::plain) {
    reference::validate(config);
    check_size(real.width, real.height, real.polynomials, real.coef.size());
    check_finite(real.coef);
    const Gram factor = gram_factor(gram);
    for (std::size_t i = 0; i < kSix; ++i) {
      for (std::size_t j = 0; j < kSix; ++j) {
        factor_[i][j] = factor(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      }
    }
    stored_ = {.width = real.width, .height = real.height, .polynomials = real.polynomials};
    stored_.origin = nearest_plane_ ? Origin::nearest_plane : Origin::plain;
    stored_.coef.resize(real.coef.size());
  }

  /// On a grid chosen for each coefficient when all above it are stored.
  [[nodiscard]] StoredMap run() {
    Lanes lanes(count());
    split(real_.coef, lanes);
    for (std::size_t i = kSix; i-- > 0;) {
      const std::vector<double> targets = make_targets(i, lanes);
      choose(i, targets, lanes);
      round(i, targets, lanes);
    }
    take(lanes, 0);
    return finish();
  }

  [[nodiscard]] StoredMap run(const Grid& grid) {
    stored_.bias = grid.bias;
    stored_.shift = grid.shift;
    Lanes lanes(std::min(count(), kBlock));
    std::vector<double> targets;
    for (std::size_t first = 0; first < count(); first += lanes.size()) {
      if (count() - first < lanes.size()) lanes = Lanes(count() - first);
      split(real_.coef.subspan(first * kSix, lanes.size() * kSix), lanes);
      for (std::size_t i = kSix; i-- > 0;) {
        make_targets(i, lanes, targets);
        round(i, targets, lanes);
      }
      take(lanes, first);
    }
    return finish();
  }

 private:
  [[nodiscard]] std::size_t count() const { return real_.coef.size() / kSix; }

  /// What coefficient i should be, given what the coefficients above it became; the error of one
  /// that is not stored yet is 0.
  void make_targets(std::size_t i, const Lanes& lanes, std::vector<double>& targets) const {
    targets = lanes.real[i];
    for (std::size_t j = i + 1; j < kSix && nearest_plane_; ++j) {
      const double share = factor_[i][j] / factor_[i][i];
      if (share != 0) subtract_share(share, lanes.error[j], targets);
    }
  }
  [[nodiscard]] std::vector<double> make_targets(std::size_t i, const Lanes& lanes) const {
    std::vector<double> targets;
    make_targets(i, lanes, targets);
    return targets;
  }

  /// Bias by the targets; shift too, when i is the first of its group to be stored. The group's
  /// other members then stand with the targets that are known so far.
  void choose(std::size_t i, const std::vector<double>& targets, const Lanes& lanes) {
    std::vector<Population> members;
    members.emplace_back(targets, weight(i));
    const auto group = shift_group(config_, i);
    if (i == group.back()) {
      for (const std::size_t other : group.first(group.size() - 1)) {
        members.emplace_back(make_targets(other, lanes), weight(other));
      }
      const int shift = best_shift(members, config_);
      for (const std::size_t member : group) stored_.shift[member] = shift;
    }
    stored_.bias[i] = best_bias(members.front(), stored_.shift[i], config_);
  }

  void round(std::size_t i, const std::vector<double>& targets, Lanes& lanes) {
    const int bias = stored_.bias[i];
    const Step step{stored_.shift[i], bias, delta_window(config_, bias)};
    stored_.saturated[i] += round_lane(targets, step, i, lanes);
    add_luminance(factor_[i], i, lanes);
  }

  /// The integers of some polynomials and what they lost.
  void take(const Lanes& lanes, std::size_t first) {
    merge(lanes, std::span(stored_.coef).subspan(first * kSix, lanes.size() * kSix));
    for (const double square : lanes.luminance) {
      squares_ += square;
      worst_ = std::max(worst_, square);
    }
  }

  [[nodiscard]] StoredMap finish() {
    stored_.rms_error = std::sqrt(squares_ / static_cast<double>(count()));
    stored_.worst_error = std::sqrt(worst_);
    return std::move(stored_);
  }

  /// What a squared error of coefficient i weighs in the luminance.
  [[nodiscard]] double weight(std::size_t i) const {
    if (nearest_plane_) return factor_[i][i] * factor_[i][i];
    double sum = 0;
    for (const Six<double>& row : factor_) sum += row[i] * row[i];
    return sum;
  }

  RealMap real_;
  EvalConfig config_;
  Six<Six<double>> factor_{};  ///< R with R^T R = G, row by row
  bool nearest_plane_;
  StoredMap stored_;
  double squares_ = 0, worst_ = 0;  ///< of the luminance's change, by polynomial
};

}  // namespace

StoredMap quantize(const RealMap& real, const EvalConfig& config, Method method, const Gram& gram) {
  return Rounder(real, config, method, gram).run();
}

StoredMap quantize_on_grid(const RealMap& real, const Grid& grid, const EvalConfig& config,
                           Method method, const Gram& gram) {
  check_grid(grid, config);
  return Rounder(real, config, method, gram).run(grid);
}

QuantizationError compare(const RealMap& real, const StoredMap& stored, const Gram& gram) {
  check_size(real.width, real.height, real.polynomials, real.coef.size());
  if (stored.coef.size() != real.coef.size()) {
    throw std::invalid_argument("maps of different sizes cannot be compared");
  }
  QuantizationError result;
  Six<double> scale{}, squares{};
  double sum = 0;
  for (std::size_t i = 0; i < kSix; ++i) scale[i] = std::ldexp(1.0, -stored.shift[i]);
  for (std::size_t k = 0; k < real.coef.size(); k += kSix) {
    Eigen::Matrix<double, 6, 1> e;
    for (std::size_t i = 0; i < kSix; ++i) {
      const double a = (int{stored.coef[k + i]} - stored.bias[i]) * scale[i];
      const double d = difference(a, real.coef[k + i]);
      e[static_cast<Eigen::Index>(i)] = d;
      squares[i] += d * d;
      result.coefficient_max[i] = std::max(result.coefficient_max[i], std::abs(d));
    }
    const double luminance = e.dot(gram * e);
    sum += luminance;
    result.worst = std::max(result.worst, luminance);
  }
  const double count = static_cast<double>(real.coef.size() / kSix);
  for (std::size_t i = 0; i < kSix; ++i) result.coefficient_rms[i] = std::sqrt(squares[i] / count);
  result.worst = std::sqrt(std::max(0.0, result.worst));
  result.rms = std::sqrt(std::max(0.0, sum / count));
  result.psnr_db =
      result.rms > 0 ? 20 * std::log10(255 / result.rms) : std::numeric_limits<double>::infinity();
  return result;
}

void record_loss(const RealMap& real, const Gram& gram, StoredMap& stored) {
  const QuantizationError lost = compare(real, stored, gram);
  stored.rms_error = lost.rms;
  stored.worst_error = lost.worst;
}

}  // namespace ptm::quantize
