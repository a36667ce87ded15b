#include "testbench/compare/lit_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "golden/render/light_map.h"
#include "golden/scene/relief.h"
#include "testbench/compare/ssim.h"

namespace ptm::testbench {
namespace {

constexpr std::size_t kBins = 256 * 8 + 1;  ///< eighths of a level, the last holds 255 and more
constexpr double kVisible = 5;

/// The least eighth of a level that all but 1/1000 of the counted differences keep.
double all_but_a_thousandth(const std::vector<std::uint64_t>& counts, std::uint64_t all) {
  std::uint64_t above = 0;
  for (std::size_t bin = counts.size(); bin-- > 0;) {
    above += counts[bin];
    if (above * 1000 > all) return static_cast<double>(bin) / 8;
  }
  return 0;
}

}  // namespace

LitDifference compare_lit(const golden::PtmMap& a, const golden::PtmMap& b,
                          std::span<const std::array<double, 2>> lights) {
  if (a.width != b.width || a.height != b.height || lights.empty()) {
    throw std::invalid_argument("maps of different sizes, or no lights, to compare");
  }
  LitDifference result;
  result.ssim = 0;
  double squares = 0;
  std::uint64_t samples = 0, visible = 0;
  std::vector<std::uint64_t> counts(kBins);
  for (const auto& [lu, lv] : lights) {
    const golden::ImageReal left = golden::light_map(a, lu, lv),
                            right = golden::light_map(b, lu, lv);
    for (std::size_t i = 0; i < left.samples.size(); ++i) {
      const double off = std::abs(left.samples[i] - right.samples[i]);
      squares += off * off;
      result.max = std::max(result.max, off);
      visible += off > kVisible ? 1U : 0U;
      ++counts[off < 255 ? static_cast<std::size_t>(std::ceil(off * 8)) : kBins - 1];
    }
    samples += left.samples.size();
    const double ssim = structural_similarity(left, right);
    result.ssim += ssim / static_cast<double>(lights.size());
    result.ssim_least = std::min(result.ssim_least, ssim);
  }
  result.rmse = std::sqrt(squares / static_cast<double>(samples));
  result.psnr_db = result.rmse > 0 ? 20 * std::log10(255 / result.rmse)
                                   : std::numeric_limits<double>::infinity();
  result.within_999 = all_but_a_thousandth(counts, samples);
  result.visible_share = static_cast<double>(visible) / static_cast<double>(samples);
  return result;
}

std::span<const std::array<double, 2>> comparison_lights() {
  static const std::vector<std::array<double, 2>> lights = [] {
    std::vector<std::array<double, 2>> made;
    for (const auto& light : golden::spread_lights(24)) made.push_back({light[0], light[1]});
    return made;
  }();
  return lights;
}

}  // namespace ptm::testbench
