#include "model/quantize/clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <thread>

namespace ptm::quantize {
namespace {

constexpr std::size_t kBlock = 256;  ///< centers whose distances are summed side by side

/// Centers in blocks, dimension by dimension, so that the innermost loop runs over centers: it
/// vectorises without changing the order of any sum.
class CenterBlocks {
 public:
  explicit CenterBlocks(const Points& centers)
      : dimensions_(centers.dimensions), count_(centers.count()) {
    const std::size_t blocks = (count_ + kBlock - 1) / kBlock;
    values_.assign(blocks * dimensions_ * kBlock, 0.0F);
    for (std::size_t c = 0; c < count_; ++c) {
      for (std::size_t d = 0; d < dimensions_; ++d) {
        values_[(c / kBlock * dimensions_ + d) * kBlock + c % kBlock] = centers.at(c)[d];
      }
    }
  }

  struct Found {
    std::uint16_t center = 0;
    float squared = INFINITY;
  };

  [[nodiscard]] Found nearest(std::span<const float> point) const {
    Found best;
    std::array<float, kBlock> squared;
    for (std::size_t first = 0; first < count_; first += kBlock) {
      squared.fill(0.0F);
      const float* row = &values_[first * dimensions_];
      for (std::size_t d = 0; d < dimensions_; ++d, row += kBlock) {
        const float x = point[d];
        for (std::size_t c = 0; c < kBlock; ++c) {
          const float difference = row[c] - x;
          squared[c] += difference * difference;
        }
      }
      const std::size_t last = std::min(kBlock, count_ - first);
      for (std::size_t c = 0; c < last; ++c) {
        if (squared[c] < best.squared) {
          best = {static_cast<std::uint16_t>(first + c), squared[c]};
        }
      }
    }
    return best;
  }

 private:
  std::size_t dimensions_, count_;
  std::vector<float> values_;  ///< [block][dimension][kBlock]
};

float squared_distance(std::span<const float> a, std::span<const float> b) {
  float sum = 0;
  for (std::size_t d = 0; d < a.size(); ++d) sum += (a[d] - b[d]) * (a[d] - b[d]);
  return sum;
}

/// A number in [0, 1).
double draw(std::uint64_t seed, std::uint64_t counter) {
  return std::ldexp(static_cast<double>(hash(seed, counter) >> 11), -53);
}

/// The point at which the running sum of `shares` passes a drawn part of the whole; none if all
/// are zero.
std::size_t draw_by_share(const std::vector<double>& shares, double part) {
  const double whole = std::accumulate(shares.begin(), shares.end(), 0.0);
  if (!(whole > 0)) return shares.size();
  double sum = 0;
  std::size_t last = shares.size();
  for (std::size_t n = 0; n < shares.size(); ++n) {
    if (shares[n] <= 0) continue;
    sum += shares[n];
    last = n;
    if (sum > part * whole) break;
  }
  return last;
}

void append(Points& centers, std::span<const float> point) {
  centers.values.insert(centers.values.end(), point.begin(), point.end());
}

/// k-means++: each further center is drawn with a chance that grows with the squared distance to
/// the centers there are.
Points first_centers(const Points& points, std::span<const double> weights, std::size_t most,
                     std::uint64_t seed, const std::function<void()>& step) {
  std::size_t steps = 0;
  Points centers{.dimensions = points.dimensions};
  std::vector<double> shares(weights.begin(), weights.end());
  std::vector<float> squared(points.count(), INFINITY);
  while (centers.count() < most) {
    const std::size_t next = draw_by_share(shares, draw(seed, centers.count()));
    if (next == points.count()) break;
    append(centers, points.at(next));
    for (; step && steps < centers.count() * kFirstSteps / most; ++steps) step();
    for (std::size_t n = 0; n < points.count(); ++n) {
      squared[n] = std::min(squared[n], squared_distance(points.at(n), points.at(next)));
      shares[n] = weights[n] * static_cast<double>(squared[n]);
    }
  }
  return centers;
}

struct Means {
  std::vector<double> sum;     ///< [center][dimensions], divided by the weight where there is any
  std::vector<double> weight;  ///< [center]
};

Means means_of(const Points& points, std::span<const double> weights,
               const std::vector<std::uint16_t>& index, const Points& centers) {
  const std::size_t dimensions = points.dimensions;
  Means means{std::vector<double>(centers.values.size()), std::vector<double>(centers.count())};
  for (std::size_t n = 0; n < points.count(); ++n) {
    means.weight[index[n]] += weights[n];
    for (std::size_t d = 0; d < dimensions; ++d) {
      means.sum[index[n] * dimensions + d] += weights[n] * static_cast<double>(points.at(n)[d]);
    }
  }
  for (std::size_t k = 0; k < means.sum.size(); ++k) {
    if (means.weight[k / dimensions] > 0) means.sum[k] /= means.weight[k / dimensions];
  }
  return means;
}

/// Gives each empty cluster the point that is worst off, one point each; keeps its old center if
/// no point is off at all.
int refill(const Points& points, std::span<const double> weights, std::vector<float>& squared,
           const Points& centers, Means& means) {
  int refilled = 0;
  for (std::size_t c = 0; c < centers.count(); ++c) {
    if (means.weight[c] > 0) continue;
    std::size_t worst = 0;
    const auto off = [&](std::size_t n) { return weights[n] * static_cast<double>(squared[n]); };
    for (std::size_t n = 1; n < points.count(); ++n) worst = off(n) > off(worst) ? n : worst;
    const bool any = off(worst) > 0;
    const auto from = any ? points.at(worst) : centers.at(c);
    std::copy(from.begin(), from.end(),
              means.sum.begin() + static_cast<std::ptrdiff_t>(c * points.dimensions));
    squared[worst] = 0;
    refilled += any ? 1 : 0;
  }
  return refilled;
}

}  // namespace

std::uint64_t hash(std::uint64_t seed, std::uint64_t counter) {
  std::uint64_t z = seed + (counter + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9U;
  z = (z ^ z >> 27) * 0x94d049bb133111ebU;
  return z ^ z >> 31;
}

std::vector<std::uint16_t> nearest(const Points& points, const Points& centers,
                                   std::vector<float>* squared) {
  const CenterBlocks blocks(centers);
  std::vector<std::uint16_t> index(points.count());
  if (squared != nullptr) squared->resize(points.count());
  const auto work = [&](std::size_t first, std::size_t last) {
    for (std::size_t n = first; n < last; ++n) {
      const CenterBlocks::Found found = blocks.nearest(points.at(n));
      index[n] = found.center;
      if (squared != nullptr) (*squared)[n] = found.squared;
    }
  };
  const std::size_t parts = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::jthread> threads;
  for (std::size_t p = 1; p < parts; ++p) {
    threads.emplace_back(work, points.count() * p / parts, points.count() * (p + 1) / parts);
  }
  work(0, points.count() / parts);
  threads.clear();  // joins them
  return index;
}

Clusters cluster(const Points& points, std::span<const double> weights, std::size_t most,
                 int rounds, std::uint64_t seed, const std::function<void()>& step) {
  return refine(points, weights, first_centers(points, weights, most, seed, step), rounds, step);
}

Clusters refine(const Points& points, std::span<const double> weights, Points centers, int rounds,
                const std::function<void()>& step) {
  Clusters clusters;
  clusters.centers = std::move(centers);
  clusters.means.assign(clusters.centers.values.begin(), clusters.centers.values.end());
  std::vector<std::uint16_t> before;
  for (clusters.rounds = 0; clusters.rounds < rounds; ++clusters.rounds) {
    std::vector<float> squared;
    std::vector<std::uint16_t> index = nearest(points, clusters.centers, &squared);
    if (index == before) break;
    Means means = means_of(points, weights, index, clusters.centers);
    clusters.refilled += refill(points, weights, squared, clusters.centers, means);
    clusters.means = std::move(means.sum);
    std::transform(clusters.means.begin(), clusters.means.end(), clusters.centers.values.begin(),
                   [](double x) { return static_cast<float>(x); });
    before = std::move(index);
    if (step) step();
  }
  return clusters;
}

}  // namespace ptm::quantize
