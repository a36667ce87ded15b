#include "golden/fit/contradiction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "golden/fit/light_solver.h"

namespace ptm::golden {
namespace {

constexpr double kRoundedLevel = 0.5;
constexpr double kChance = 0.01;           ///< that the largest of them all exceeds the limit
constexpr double kMedianToSigma = 1.4826;  ///< of normal numbers
constexpr double kAlone = 1e-9;            ///< 1 - h of a light that no other light speaks for
constexpr std::size_t kFewestBeyondRank = 3, kFewestFigures = 4, kMostTakenOut = 10;

using Design = Eigen::Matrix<double, Eigen::Dynamic, 6>;
using Figures = std::vector<std::optional<double>>;
using Set = std::vector<Eigen::Index>;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// k with n P(x > k) = kChance for a normal x, by bisection.
double largest_normal(std::size_t n) {
  double low = 0, high = 10;
  for (int step = 0; step < 60; ++step) {
    const double k = (low + high) / 2;
    const double chance = 0.5 * std::erfc(k / std::numbers::sqrt2) * static_cast<double>(n);
    (chance > kChance ? low : high) = k;
  }
  return high;
}

double logarithm(double figure) { return std::log(std::max(figure, kRoundedLevel)); }

/// What the figures of a set of photographs lead to expect of any.
class Expectation {
 public:
  Expectation(const Figures& figures, const Set& set, const Eigen::VectorXd& slant) {
    std::vector<double> logs, slants;
    for (const Eigen::Index i : set) {
      const auto& figure = figures[static_cast<std::size_t>(i)];
      if (!figure) continue;
      logs.push_back(logarithm(*figure));
      slants.push_back(slant[i]);
    }
    if (logs.size() < kFewestFigures) return;
    slope_ = trend(slants, logs);
    for (std::size_t i = 0; i < logs.size(); ++i) logs[i] -= slope_ * slants[i];
    const double middle = median(logs), k = largest_normal(logs.size());
    for (double& x : logs) x = std::abs(x - middle);
    limit_ = middle + std::max(k * kMedianToSigma * median(logs), std::numbers::ln2);
  }
  [[nodiscard]] bool is_exceeded(const std::optional<double>& figure, double slant) const {
    return figure && logarithm(*figure) - slope_ * slant > limit_;
  }

 private:
  /// The median slope of all pairs (Theil and Sen), which a quarter of bad ones does not turn.
  static double trend(const std::vector<double>& x, const std::vector<double>& y) {
    std::vector<double> slopes;
    for (std::size_t i = 0; i < x.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (std::abs(x[i] - x[j]) > 1e-6) slopes.push_back((y[i] - y[j]) / (x[i] - x[j]));
      }
    }
    return slopes.empty() ? 0 : std::max(0.0, median(std::move(slopes)));
  }

  double slope_ = 0, limit_ = std::numeric_limits<double>::infinity();
};

class Finder {
 public:
  explicit Finder(const ContradictionSample& sample)
      : sample_(sample),
        photographs_(sample.designs.at(0).rows()),
        slant_(sample.designs[0].col(0) + sample.designs[0].col(1)) {}

  Contradictions find() {
    Set set(sample_.fitted);
    std::iota(set.begin(), set.end(), Eigen::Index{0});
    Set out;
    std::size_t failed = 0;
    const std::size_t most = std::min(sample_.fitted / 4, kMostTakenOut);
    Figures figures = figures_of(set);
    while (out.size() < most && set.size() > rank_ + kFewestBeyondRank) {
      const auto worst = std::max_element(set.begin(), set.end(), [&](auto a, auto b) {
        return at(figures, a).value_or(0) < at(figures, b).value_or(0);
      });
      out.push_back(*worst);
      set.erase(worst);
      figures = figures_of(set);
      const Eigen::Index last = out.back();
      if (Expectation(figures, set, slant_).is_exceeded(at(figures, last), slant_[last])) {
        failed = out.size();
      }
    }
    set.insert(set.end(), out.begin() + static_cast<std::ptrdiff_t>(failed), out.end());
    out.resize(failed);
    figures = figures_of(set);
    Contradictions found{figures, std::vector<bool>(figures.size())};
    const Expectation expected(figures, set, slant_);
    for (const Eigen::Index i : out) found.contradicts[static_cast<std::size_t>(i)] = true;
    for (std::size_t i = sample_.fitted; i < figures.size(); ++i) {
      found.contradicts[i] = expected.is_exceeded(figures[i], slant_[static_cast<Eigen::Index>(i)]);
    }
    return found;
  }

 private:
  static const std::optional<double>& at(const Figures& figures, Eigen::Index i) {
    return figures[static_cast<std::size_t>(i)];
  }

  /// Adds each photograph's r^2 over its variance, in a fit of those in `set`.
  Figures figures_of(const Set& set) {
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(photographs_), variances = squares;
    for (std::size_t t = 0; t < sample_.levels.size(); ++t) {
      const Design& design = sample_.designs[sample_.designs.size() == 1 ? 0 : t];
      if (t == 0 || sample_.designs.size() > 1) prepare(design, set);
      const Eigen::VectorXd& y = sample_.levels[t];
      const Eigen::Matrix<double, 6, 1> a = solver_.inverse * y(set);
      const Eigen::ArrayXd residuals = (y - design * a).array();
      squares.array() += residuals.square() / variance_.array().max(kAlone);
      variances += variance_;
    }
    const auto texels = static_cast<double>(sample_.levels.size());
    Figures figures(static_cast<std::size_t>(photographs_));
    for (Eigen::Index i = 0; i < photographs_; ++i) {
      if (variances[i] < kAlone * texels) continue;
      figures[static_cast<std::size_t>(i)] = std::sqrt(squares[i] / texels);
    }
    return figures;
  }

  void prepare(const Design& design, const Set& set) {
    solver_ = solve_design(design(set, Eigen::all));
    rank_ = static_cast<std::size_t>(solver_.rank);
    // The variance of the prediction b . P y is |P^T b|^2, which is h.
    const Eigen::VectorXd h = (design * solver_.inverse).rowwise().squaredNorm();
    variance_ = (1 + h.array()).matrix();
    for (const Eigen::Index i : set) variance_[i] = 1 - h[i];
  }

  const ContradictionSample& sample_;
  Eigen::Index photographs_;
  Eigen::VectorXd slant_;  ///< u^2 + v^2 of each light
  LightSolver solver_;
  Eigen::VectorXd variance_;  ///< of each photograph's residual
  std::size_t rank_ = 6;
};

}  // namespace

Contradictions find_contradictions(const ContradictionSample& sample) {
  return Finder(sample).find();
}

}  // namespace ptm::golden
