// Pictures of three planes, each focused elsewhere.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "golden/scene/image_stack.h"
#include "golden/scene/noise.h"

namespace ptm::golden {
namespace {

using Pixel = std::array<double, 4>;  ///< premultiplied, 0..1
using Layer = std::vector<Pixel>;

constexpr std::array<double, 3> kDepths{0.9, 0.0, -0.9};  ///< far, middle, near: lu in focus
constexpr double kBlur = 0.028;  ///< radius in widths, for each unit of lu out of focus

Pixel opaque(double r, double g, double b) { return {r, g, b, 1}; }

/// A wall of bricks.
Pixel far_plane(std::uint64_t seed, double u, double v) {
  const double row = std::floor(v * 16), shift = std::fmod(row, 2) / 2;
  const double x = u * 8 + shift, column = std::floor(x);
  const bool joint = x - column < 0.07 || v * 16 - row < 0.14;
  if (joint) return opaque(0.85, 0.82, 0.75);
  const double tone =
      hash_noise(seed, static_cast<std::int64_t>(column), static_cast<std::int64_t>(row));
  return opaque(0.5 + 0.2 * tone, 0.22 + 0.12 * tone, 0.14 + 0.1 * tone);
}

/// A target of rings on a board.
Pixel middle_plane(double u, double v) {
  const double r = std::hypot(u - 0.64, v - 0.42);
  if (r > 0.3) return {};
  const bool light = std::fmod(r, 0.06) < 0.03;
  return light ? opaque(0.95, 0.95, 0.9) : opaque(0.1, 0.2, 0.55);
}

/// A grating before the lower left.
Pixel near_plane(double u, double v) {
  if (u < 0.05 || u > 0.5 || v < 0.5 || v > 0.95) return {};
  const bool frame = u < 0.09 || u > 0.46 || v < 0.54 || v > 0.91;
  if (!frame && std::fmod(u + v, 0.07) > 0.035) return {};
  return opaque(0.1, 0.45, 0.2);
}

Layer layer_of(const TextureSpec& spec, std::size_t which) {
  const int width = spec.size[0], height = spec.size[1];
  Layer layer;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double u = (x + 0.5) / width, v = (y + 0.5) / height;
      layer.push_back(which == 0   ? far_plane(spec.seed, u, v)
                      : which == 1 ? middle_plane(u, v)
                                   : near_plane(u, v));
    }
  }
  return layer;
}

/// The mean over a disc about each pixel; the edge's pixels go on beyond it.
Layer blurred(const Layer& layer, int width, int height, double radius) {
  const int reach = static_cast<int>(radius);
  if (reach == 0) return layer;
  Layer out(layer.size());
  tbb::parallel_for(0, height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      Pixel sum{};
      double count = 0;
      for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
          if (dx * dx + dy * dy > radius * radius) continue;
          const int sx = std::clamp(x + dx, 0, width - 1), sy = std::clamp(y + dy, 0, height - 1);
          const Pixel& p = layer[static_cast<std::size_t>(sy * width + sx)];
          for (std::size_t c = 0; c < 4; ++c) sum[c] += p[c];
          count += 1;
        }
      }
      for (double& value : sum) value /= count;
      out[static_cast<std::size_t>(y * width + x)] = sum;
    }
  });
  return out;
}

}  // namespace

std::vector<StackPicture> focus_pictures(const TextureSpec& spec) {
  const int width = spec.size[0], height = spec.size[1];
  std::vector<Layer> layers;
  for (std::size_t k = 0; k < kDepths.size(); ++k) layers.push_back(layer_of(spec, k));
  std::vector<StackPicture> pictures;
  for (int n = 0; n < kFocusPictures; ++n) {
    const double focus = 2.0 * n / (kFocusPictures - 1) - 1;
    StackPicture picture(layers[0].size() * 3);
    for (std::size_t k = 0; k < layers.size(); ++k) {
      const double radius = kBlur * width * std::abs(kDepths[k] - focus);
      const Layer layer = blurred(layers[k], width, height, radius);
      for (std::size_t p = 0; p < layer.size(); ++p) {
        for (std::size_t c = 0; c < 3; ++c) {
          double& value = picture[p * 3 + c];
          value = 255 * layer[p][c] + (1 - layer[p][3]) * value;
        }
      }
    }
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

}  // namespace ptm::golden
