#include "model/quantize/quantize.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "model/quantize/choose_grid.h"

namespace ptm::quantize {
namespace {

using reference::EvalConfig;

/// stored - real, limited so that its square stays finite for any finite coefficient.
double difference(double stored, double real) { return std::clamp(stored - real, -1e100, 1e100); }

/// The six coefficients of all polynomials of a map, stored one after the other from a5 down.
class Rounder {
 public:
  Rounder(const RealMap& real, const EvalConfig& config, Method method, const Gram& gram)
      : real_(real),
        config_(config),
        factor_(gram_factor(gram)),
        nearest_plane_(method != Method::plain) {
    reference::validate(config);
    check_size(real.width, real.height, real.polynomials, real.coef.size());
    check_finite(real.coef);
    stored_ = {.width = real.width, .height = real.height, .polynomials = real.polynomials};
    stored_.origin = nearest_plane_ ? Origin::nearest_plane : Origin::plain;
    stored_.coef.resize(real.coef.size());
  }

  [[nodiscard]] StoredMap run(const std::optional<Grid>& given) {
    for (std::size_t i = kSix; i-- > 0;) {
      const std::vector<double> targets = make_targets(i);
      if (given) {
        stored_.bias[i] = given->bias[i];
        stored_.shift[i] = given->shift[i];
      } else {
        choose(i, targets);
      }
      round(i, targets);
    }
    const Gram g = factor_.transpose() * factor_;
    record_loss(real_, g, stored_);
    return std::move(stored_);
  }

 private:
  [[nodiscard]] std::size_t count() const { return real_.coef.size() / kSix; }

  /// What coefficient i should be, given what the coefficients above it became.
  [[nodiscard]] std::vector<double> make_targets(std::size_t i) const {
    std::vector<double> targets(count());
    for (std::size_t t = 0; t < targets.size(); ++t) targets[t] = real_.coef[t * kSix + i];
    for (std::size_t j = i + 1; j < kSix && nearest_plane_; ++j) {
      const double share = entry(i, j) / entry(i, i);
      if (error_[j].empty() || share == 0) continue;
      for (std::size_t t = 0; t < targets.size(); ++t) targets[t] -= share * error_[j][t];
    }
    return targets;
  }

  /// Bias by the targets; shift too, when i is the first of its group to be stored. The group's
  /// other members then stand with the targets that are known so far.
  void choose(std::size_t i, const std::vector<double>& targets) {
    std::vector<Population> members;
    members.emplace_back(targets, weight(i));
    const auto group = shift_group(config_, i);
    if (i == group.back()) {
      for (const std::size_t other : group.first(group.size() - 1)) {
        members.emplace_back(make_targets(other), weight(other));
      }
      const int shift = best_shift(members, config_);
      for (const std::size_t member : group) stored_.shift[member] = shift;
    }
    stored_.bias[i] = best_bias(members.front(), stored_.shift[i], config_);
  }

  void round(std::size_t i, const std::vector<double>& targets) {
    const Window window = delta_window(config_, stored_.bias[i]);
    const double up = std::ldexp(1.0, stored_.shift[i]), down = std::ldexp(1.0, -stored_.shift[i]);
    error_[i].resize(nearest_plane_ ? targets.size() : 0);
    for (std::size_t t = 0; t < targets.size(); ++t) {
      const double rounded = std::floor(targets[t] * up + 0.5);
      const double delta = std::clamp(rounded, double(window.low), double(window.high));
      stored_.saturated[i] += delta != rounded ? 1U : 0U;
      const int coef = static_cast<int>(delta) + stored_.bias[i];
      stored_.coef[t * kSix + i] = static_cast<std::uint16_t>(coef);
      if (nearest_plane_) error_[i][t] = difference(delta * down, real_.coef[t * kSix + i]);
    }
  }

  [[nodiscard]] double entry(std::size_t i, std::size_t j) const {
    return factor_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
  /// What a squared error of coefficient i weighs in the luminance.
  [[nodiscard]] double weight(std::size_t i) const {
    if (nearest_plane_) return entry(i, i) * entry(i, i);
    return factor_.col(static_cast<Eigen::Index>(i)).squaredNorm();
  }

  RealMap real_;
  EvalConfig config_;
  Gram factor_;
  bool nearest_plane_;
  StoredMap stored_;
  Six<std::vector<double>> error_;  ///< stored less real, of the coefficients already stored
};

}  // namespace

StoredMap quantize(const RealMap& real, const EvalConfig& config, Method method, const Gram& gram) {
  return Rounder(real, config, method, gram).run({});
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
