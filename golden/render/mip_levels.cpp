#include "golden/render/mip_levels.h"

#include <algorithm>
#include <cmath>

namespace ptm::golden {
namespace {

constexpr std::size_t kMapChannels = 18;

std::size_t texel_index(int width, int i, int j) {
  return static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(i);
}

double clamped(double level) { return std::clamp(level, 0.0, 255.0); }

/// Three polynomials, of what red, green and blue radiate.
MipLevel radiated(const LoadedTexture& texture) {
  MipLevel level{texture.width, texture.height, {}};
  level.values.reserve(texture.texels() * kMapChannels);
  for (std::size_t t = 0; t < texture.texels(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < 6; ++k) {
        level.values.push_back(texture.polynomials == 3
                                   ? texture.coef[(t * 3 + c) * 6 + k]
                                   : colored(texture.color[t * 3 + c], texture.coef[t * 6 + k]));
      }
    }
  }
  return level;
}

struct Share {
  int source = 0;
  double weight = 0;
};
/// What one texel of the half covers along a side: sources overlap [n, n + 1) side / half.
std::vector<Share> shares(int target, int side, int half) {
  const double size = static_cast<double>(side) / half;
  const double from = target * size, to = (target + 1) * size;
  std::vector<Share> found;
  for (int s = static_cast<int>(from); s < side && s < to; ++s) {
    const double overlap = std::min(to, s + 1.0) - std::max(from, static_cast<double>(s));
    if (overlap > 0) found.push_back({s, overlap / size});
  }
  return found;
}

Coefficients polynomial(const std::vector<double>& values, std::size_t first) {
  Coefficients a{};
  std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(first), 6, a.begin());
  return a;
}

}  // namespace

MipLevel halve(const MipLevel& level, std::size_t channels) {
  MipLevel half{std::max(1, level.width / 2), std::max(1, level.height / 2), {}};
  half.values.assign(texel_index(half.width, 0, half.height) * channels, 0);
  for (int j = 0; j < half.height; ++j) {
    const auto rows = shares(j, level.height, half.height);
    for (int i = 0; i < half.width; ++i) {
      double* out = &half.values[texel_index(half.width, i, j) * channels];
      for (const Share& column : shares(i, level.width, half.width)) {
        for (const Share& row : rows) {
          const double* in =
              &level.values[texel_index(level.width, column.source, row.source) * channels];
          const double weight = column.weight * row.weight;
          for (std::size_t c = 0; c < channels; ++c) out[c] += weight * in[c];
        }
      }
    }
  }
  return half;
}

MipTexture::MipTexture(const LoadedTexture& texture, bool levels) : texture_(&texture) {
  if (!levels || (texture.width == 1 && texture.height == 1)) return;
  const std::size_t channels = texture.is_picture() ? 4 : kMapChannels;
  below_.push_back(halve(texture.is_picture()
                             ? MipLevel{texture.width, texture.height, texture.rgba}
                             : radiated(texture),
                         channels));
  while (below_.back().width > 1 || below_.back().height > 1) {
    below_.push_back(halve(below_.back(), channels));
  }
}

int MipTexture::width(int level) const {
  return level == 0 ? texture_->width : below_[static_cast<std::size_t>(level) - 1].width;
}

int MipTexture::height(int level) const {
  return level == 0 ? texture_->height : below_[static_cast<std::size_t>(level) - 1].height;
}

Rgba MipTexture::texel(int level, int i, int j, const std::array<double, 2>& light) const {
  const std::size_t t = texel_index(width(level), i, j);
  Rgba out{0, 0, 0, 255};
  if (texture_->is_picture()) {
    const auto& values =
        level == 0 ? texture_->rgba : below_[static_cast<std::size_t>(level) - 1].values;
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(t * 4), 4, out.begin());
    return out;
  }
  const auto [lu, lv] = light;
  if (level == 0 && texture_->polynomials == 1) {
    const double l = luminance(polynomial(texture_->coef, t * 6), lu, lv);
    for (std::size_t c = 0; c < 3; ++c) out[c] = clamped(colored(texture_->color[t * 3 + c], l));
    return out;
  }
  const auto& values =
      level == 0 ? texture_->coef : below_[static_cast<std::size_t>(level) - 1].values;
  for (std::size_t c = 0; c < 3; ++c) {
    out[c] = clamped(luminance(polynomial(values, t * kMapChannels + c * 6), lu, lv));
  }
  return out;
}

}  // namespace ptm::golden
