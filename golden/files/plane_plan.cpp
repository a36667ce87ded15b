#include "golden/files/plane_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "golden/files/prediction.h"

namespace ptm::golden {
namespace {

using Histogram = std::array<std::uint32_t, 256>;

/// Bits a texel of a histogram's order-0 entropy.
double entropy(const Histogram& counts) {
  double total = 0;
  for (const std::uint32_t count : counts) total += count;
  double bits = 0;
  for (const std::uint32_t count : counts) {
    if (count != 0) bits -= count * std::log2(count / total);
  }
  return total == 0 ? 0 : bits / total;
}

/// Rows spread over the picture, of at most 64 Ki texels (but at least one row).
class Sample {
 public:
  Sample(int width, int height)
      : width_(static_cast<std::size_t>(width)), height_(static_cast<std::size_t>(height)) {
    const std::size_t texels = width_ * height_;
    step_ = std::max<std::size_t>(1, (texels + most - 1) / most);
  }

  /// Bits a texel of a plane whose coded bytes are difference(texel) + 128, or the values as they
  /// are where `difference` never leaves -128..127.
  template <class Difference>
  [[nodiscard]] double cost(Differences kind, Difference difference) const {
    constexpr double record_bits = 40;
    Histogram counts{};
    std::size_t beyond = 0, seen = 0;
    for (std::size_t row = 0; row < height_; row += step_, seen += width_) {
      int left = 0;
      for (std::size_t i = row * width_; i < (row + 1) * width_; ++i) {
        int here = difference(i);
        if (kind == Differences::clamped) {
          beyond += here < -128 || here > 127 ? 1 : 0;
          here = std::clamp(here, -128, 127);
        }
        ++counts[static_cast<std::size_t>((here - left) & 255)];
        left = here;
      }
    }
    return entropy(counts) + record_bits * static_cast<double>(beyond) / static_cast<double>(seen);
  }

 private:
  static constexpr std::size_t most = std::size_t{1} << 16;
  std::size_t width_, height_, step_;
};

struct Choice {
  double cost = 0;
  std::size_t plane = 0;
  int reference = -1;
  int transform = 0;
};

std::vector<Choice> choices_of(const std::vector<Plane>& planes, const Sample& sample,
                               Differences kind, bool allow_inversion) {
  std::vector<Choice> choices;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const auto value = planes[p].bytes();
    choices.push_back({sample.cost(kind, [&](std::size_t i) { return value[i] - 128; }), p, -1, 0});
    for (std::size_t r = 0; r < planes.size(); ++r) {
      if (r == p) continue;
      const auto reference = planes[r].bytes();
      for (int transform = 0; transform <= (allow_inversion ? 1 : 0); ++transform) {
        const double cost = sample.cost(kind, [&](std::size_t i) {
          return value[i] - predictor(reference[i], transform == 1);
        });
        choices.push_back({cost, p, static_cast<int>(r), transform});
      }
    }
  }
  return choices;
}

}  // namespace

PlanePlan plan_planes(const std::vector<Plane>& planes, int width, int height,
                      Differences differences, bool allow_inversion) {
  const std::size_t count = planes.size();
  std::vector<Choice> choices =
      choices_of(planes, Sample(width, height), differences, allow_inversion);
  // Stable, so that equal costs keep "alone before difference, not inverted before inverted".
  std::stable_sort(choices.begin(), choices.end(),
                   [](const Choice& a, const Choice& b) { return a.cost < b.cost; });
  PlanePlan plan{std::vector<int>(count, -1), std::vector<int>(count, -1),
                 std::vector<int>(count, 0)};
  for (int position = 0; position < static_cast<int>(count); ++position) {
    const auto next = std::find_if(choices.begin(), choices.end(), [&](const Choice& choice) {
      const bool placed = plan.order[choice.plane] >= 0;
      const bool ready =
          choice.reference < 0 || plan.order[static_cast<std::size_t>(choice.reference)] >= 0;
      return !placed && ready;
    });
    plan.order[next->plane] = position;
    plan.references[next->plane] = next->reference;
    plan.transforms[next->plane] = next->transform;
  }
  return plan;
}

}  // namespace ptm::golden
