#include "model/quantize/palette.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "model/quantize/clusters.h"
#include "model/quantize/quantize.h"

namespace ptm::quantize {
namespace {

void check(const RealMap& map, std::span<const double> weights, const PaletteOptions& options) {
  check_size(map.width, map.height, map.polynomials, map.coef.size());
  check_finite(map.coef);
  if (options.entries < 2 || options.entries > 65536 || options.rounds < 1) {
    throw std::invalid_argument("a palette of " + std::to_string(options.entries) + " entries in " +
                                std::to_string(options.rounds) +
                                " rounds; expected 2 to 65536 entries, 1 round or more");
  }
  if (weights.empty()) return;
  const std::size_t texels = map.coef.size() / kSix / static_cast<std::size_t>(map.polynomials);
  const bool usable = weights.size() == texels &&
                      std::all_of(weights.begin(), weights.end(),
                                  [](double w) { return std::isfinite(w) && w >= 0; }) &&
                      std::any_of(weights.begin(), weights.end(), [](double w) { return w > 0; });
  if (!usable) {
    throw std::invalid_argument(
        "weights of a palette: expected one a texel, not negative, not all "
        "zero");
  }
}

using Polynomial = Eigen::Matrix<double, 6, 1>;

/// R times every polynomial, in single precision.
Points transform(std::span<const double> coef, std::size_t polynomials, const Gram& factor) {
  Points points{.dimensions = polynomials * kSix, .values = std::vector<float>(coef.size())};
  for (std::size_t k = 0; k < coef.size(); k += kSix) {
    const Polynomial x = factor * Eigen::Map<const Polynomial>(&coef[k]);
    for (std::size_t i = 0; i < kSix; ++i) {
      const double value = std::clamp(x[static_cast<Eigen::Index>(i)], -1e15, 1e15);
      points.values[k + i] = static_cast<float>(value);  // their squares stay finite
    }
  }
  return points;
}

/// The texels to look at, in order: those whose hashes are least, all of them where `most` allows.
std::vector<std::size_t> choose_sample(std::size_t texels, const PaletteOptions& options) {
  std::vector<std::size_t> chosen(texels);
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  if (options.sample == 0 || texels <= options.sample) return chosen;
  const auto rank = [&](std::size_t t) { return hash(options.seed ^ 0x5a3c6e1f, t); };
  std::nth_element(
      chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(options.sample), chosen.end(),
      [&](std::size_t a, std::size_t b) { return std::pair(rank(a), a) < std::pair(rank(b), b); });
  chosen.resize(options.sample);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

Points pick(const Points& points, const std::vector<std::size_t>& chosen) {
  Points picked{.dimensions = points.dimensions, .values = {}};
  picked.values.reserve(chosen.size() * points.dimensions);
  for (const std::size_t t : chosen) {
    const auto point = points.at(t);
    picked.values.insert(picked.values.end(), point.begin(), point.end());
  }
  return picked;
}

}  // namespace

int palette_steps(const PaletteOptions& options) { return kFirstSteps + options.rounds; }

int Palette::entries() const { return static_cast<int>(coef.size() / kSix) / polynomials; }

RealMap Palette::view() const {
  return {.width = entries(), .height = 1, .polynomials = polynomials, .coef = coef};
}

Palette make_palette(const RealMap& map, std::span<const double> weights,
                     const PaletteOptions& options, const Gram& gram) {
  check(map, weights, options);
  const Gram factor = gram_factor(gram);
  const Points points = transform(map.coef, static_cast<std::size_t>(map.polynomials), factor);
  const std::vector<std::size_t> chosen = choose_sample(points.count(), options);
  std::vector<double> sample_weights(chosen.size(), 1.0);
  for (std::size_t n = 0; n < chosen.size() && !weights.empty(); ++n) {
    sample_weights[n] = weights[chosen[n]];
  }
  if (std::all_of(sample_weights.begin(), sample_weights.end(), [](double w) { return w == 0; })) {
    std::fill(sample_weights.begin(), sample_weights.end(), 1.0);  // only black texels were drawn
  }
  const Clusters clusters =
      cluster(pick(points, chosen), sample_weights, static_cast<std::size_t>(options.entries),
              options.rounds, options.seed, options.step);
  Palette palette{.polynomials = map.polynomials,
                  .coef = {},
                  .index = nearest(points, clusters.centers),
                  .rounds = clusters.rounds,
                  .refilled = clusters.refilled};
  palette.coef.resize(clusters.means.size());
  const auto upper = factor.triangularView<Eigen::Upper>();
  for (std::size_t k = 0; k < palette.coef.size(); k += kSix) {
    Eigen::Map<Polynomial>(&palette.coef[k]) =
        upper.solve(Eigen::Map<const Polynomial>(&clusters.means[k]));
  }
  return palette;
}

StoredMap store_palette(const RealMap& map, const Palette& palette, const Grid& grid,
                        const reference::EvalConfig& config, const Gram& gram) {
  const StoredMap table =
      quantize_on_grid(palette.view(), grid, config, Method::nearest_plane, gram);
  StoredMap stored = table;
  stored.width = map.width;
  stored.height = map.height;
  stored.coef.clear();
  const std::size_t entry = static_cast<std::size_t>(palette.polynomials) * kSix;
  for (const std::uint16_t index : palette.index) {
    const auto from = table.coef.begin() + static_cast<std::ptrdiff_t>(index * entry);
    stored.coef.insert(stored.coef.end(), from, from + static_cast<std::ptrdiff_t>(entry));
  }
  record_loss(map, gram, stored);
  return stored;
}

}  // namespace ptm::quantize
