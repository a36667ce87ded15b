#include "golden/fit/fit_lrgb.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ptm::golden {
namespace {

constexpr std::size_t kTileTexels = 2048;  ///< 60 lights of doubles: 1 MB, stays in the cache

using Samples = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;  // [light][texel]

/// Luminance of each texel under each light, 1 at the texel's brightest; black texels stay 0.
Samples normalised_luminance(const PhotoTile& tile) {
  Samples y(static_cast<Eigen::Index>(tile.samples.size()), static_cast<Eigen::Index>(tile.texels));
  for (Eigen::Index i = 0; i < y.rows(); ++i) {
    const float* rgb = tile.samples[static_cast<std::size_t>(i)].data();
    for (Eigen::Index t = 0; t < y.cols(); ++t, rgb += 3) {
      y(i, t) = kLumaWeights[0] * double{rgb[0]} + kLumaWeights[1] * double{rgb[1]} +
                kLumaWeights[2] * double{rgb[2]};
    }
  }
  for (Eigen::Index t = 0; t < y.cols(); ++t) {
    const double most = y.col(t).maxCoeff();
    if (most > 0) y.col(t) /= most;
  }
  return y;
}

/// The colour whose product with the normalised luminance is nearest to all photographs.
void fit_colors(const PhotoTile& tile, const Samples& y, std::span<std::uint8_t> color) {
  for (std::size_t t = 0; t < tile.texels; ++t) {
    const auto column = y.col(static_cast<Eigen::Index>(t));
    const double squares = column.squaredNorm();
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i < tile.samples.size(); ++i) {
      const double weight = column[static_cast<Eigen::Index>(i)];
      for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * double{tile.samples[i][t * 3 + c]};
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const double level = squares > 0 ? std::clamp(sum[c] / squares, 0.0, 255.0) : 0.0;
      color[t * 3 + c] = static_cast<std::uint8_t>(std::floor(level + 0.5));
    }
  }
}

}  // namespace

void fit_lrgb_tile(const PhotoTile& tile, const LightSolver& solver, std::span<double> coef,
                   std::span<std::uint8_t> color) {
  const auto lights = static_cast<Eigen::Index>(tile.samples.size());
  if (lights != solver.inverse.cols() || coef.size() != tile.texels * 6 ||
      color.size() != tile.texels * 3) {
    throw std::invalid_argument("a tile of a fit whose sizes do not agree");
  }
  const Samples y = normalised_luminance(tile);
  using Coefficients = Eigen::Matrix<double, 6, Eigen::Dynamic>;  // column-major: [texel][6]
  Eigen::Map<Coefficients> out(coef.data(), 6, static_cast<Eigen::Index>(tile.texels));
  out.noalias() = (255 * solver.inverse) * y;
  fit_colors(tile, y, color);
}

LrgbFit fit_lrgb(const Capture& capture, const LightSolver& solver) {
  LrgbFit fit{.width = capture.width, .height = capture.height, .coef = {}, .color = {}};
  const std::size_t texels =
      static_cast<std::size_t>(capture.width) * static_cast<std::size_t>(capture.height);
  fit.coef.resize(texels * 6);
  fit.color.resize(texels * 3);
  const std::size_t tiles = (texels + kTileTexels - 1) / kTileTexels;
  tbb::parallel_for(std::size_t{0}, tiles, [&](std::size_t n) {
    const std::size_t first = n * kTileTexels;
    PhotoTile tile{.texels = std::min(kTileTexels, texels - first), .samples = {}};
    for (const Image<float>& photograph : capture.photographs) {
      tile.samples.push_back(std::span(photograph.samples).subspan(first * 3, tile.texels * 3));
    }
    fit_lrgb_tile(tile, solver, std::span(fit.coef).subspan(first * 6, tile.texels * 6),
                  std::span(fit.color).subspan(first * 3, tile.texels * 3));
  });
  return fit;
}

}  // namespace ptm::golden
