#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

/// k-means over points of any dimension: what palettes are made of (model/quantize/palette.h).
namespace ptm::quantize {

/// Points in single precision, one after the other.
struct Points {
  std::size_t dimensions = 0;
  std::vector<float> values = {};  ///< [point][dimensions]

  [[nodiscard]] std::size_t count() const { return values.size() / dimensions; }
  [[nodiscard]] std::span<const float> at(std::size_t n) const {
    return std::span(values).subspan(n * dimensions, dimensions);
  }
};

/// 64 well-mixed bits of a pair of numbers (the finaliser of SplitMix64, Steele, Lea, Flood 2014).
[[nodiscard]] std::uint64_t hash(std::uint64_t seed, std::uint64_t counter);

struct Clusters {
  Points centers;             ///< rounded `means`
  std::vector<double> means;  ///< [center][dimensions]
  int rounds = 0;
  int refilled = 0;
};

/// At most `most` weighted clusters: k-means++, then rounds until no point changes its cluster or
/// `rounds` are over. Points and weights of one number, at least one weight positive. A point of
/// weight 0 is never made an entry of its own. `step`, if any, is called kFirstSteps times while
/// the first centers are drawn and once a round.
[[nodiscard]] Clusters cluster(const Points& points, std::span<const double> weights,
                               std::size_t most, int rounds, std::uint64_t seed,
                               const std::function<void()>& step = {});
inline constexpr int kFirstSteps = 16;

/// The rounds alone, from given centers. A center that no point is nearest to moves to the point
/// that is worst off, weight times squared distance, one point for each such center.
[[nodiscard]] Clusters refine(const Points& points, std::span<const double> weights, Points centers,
                              int rounds, const std::function<void()>& step = {});

/// For each point the nearest center, the first of equals. On all cores; the result does not
/// depend on how many. `squared`, where wanted, receives the squared distances.
[[nodiscard]] std::vector<std::uint16_t> nearest(const Points& points, const Points& centers,
                                                 std::vector<float>* squared = nullptr);

}  // namespace ptm::quantize
