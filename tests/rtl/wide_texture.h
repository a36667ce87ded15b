#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "model/reference/unit/unit_fragment.h"
#include "model/reference/unit/unit_memory.h"

/// Colour textures of up to 4,096 texels a side, drawn alone, whose texels are their own numbers.
namespace ptm::tests {

struct WideTexture {
  int width = 4096, height = 4096;
  reference::Wrap wrap = reference::Wrap::clamp;
  bool bilinear = true;
};

inline std::string name_of(const WideTexture& t) {
  constexpr std::array<const char*, 3> kWraps{"Repeat", "Mirror", "Clamp"};
  return (t.bilinear ? "Bilinear" : "Point") +
         std::string(kWraps[static_cast<std::size_t>(t.wrap)]) + std::to_string(t.width) + 'x' +
         std::to_string(t.height);
}

/// Red, green and blue of texel (i, j): its 24 bits, those of i lowest.
constexpr std::uint32_t wide_texel(int i, int j) {
  return static_cast<std::uint32_t>(i) | static_cast<std::uint32_t>(j) << 12;
}

/// One draw: the texture's colour replaces everything. The lines are laid out here, by what the
/// page says: tile after tile, 4 x 4 texels each, row by row.
inline reference::UnitState wide_state(const WideTexture& texture) {
  reference::UnitState state;
  reference::Draw draw;
  draw.format = reference::TextureFormat::none;
  draw.combine = reference::Combine::replace;
  draw.color = true;
  draw.bilinear = texture.bilinear;
  draw.wrap_u = draw.wrap_v = texture.wrap;
  draw.color_texture.width = texture.width;
  draw.color_texture.height = texture.height;
  draw.color_texture.levels = 1;
  state.draws.push_back(draw);
  const int across = (texture.width + 3) / 4, down = (texture.height + 3) / 4;
  state.memory.resize(static_cast<std::size_t>(across) * static_cast<std::size_t>(down));
  for (std::size_t line = 0; line < state.memory.size(); ++line) {
    const int x = static_cast<int>(line) % across * 4, y = static_cast<int>(line) / across * 4;
    for (int k = 0; k < 16; ++k) {
      state.memory[line][static_cast<std::size_t>(k)] =
          wide_texel(x + k % 4, y + k / 4) | 0xff000000U;
    }
  }
  return state;
}

/// Texel k of the endless row that the wrap mode stands for.
inline int endless_texel(reference::Wrap wrap, std::int64_t k, int side) {
  const auto modulo = [](std::int64_t value, std::int64_t by) { return ((value % by) + by) % by; };
  if (wrap == reference::Wrap::clamp) {
    return static_cast<int>(std::clamp<std::int64_t>(k, 0, side - 1));
  }
  if (wrap == reference::Wrap::repeat) return static_cast<int>(modulo(k, side));
  const std::int64_t both = modulo(k, 2 * side);
  return static_cast<int>(both < side ? both : 2 * side - 1 - both);
}

/// The texels between which a coordinate lies, and the weight of the second one: of a position
/// u * side / 2^20 between texels whose centres are at halves. Exact where `side` divides 2^20.
struct EndlessPlace {
  int first, second;
  double weight;
};
inline EndlessPlace endless_place(const WideTexture& texture, std::int32_t u, int side) {
  const double position = u * static_cast<double>(side) / (1 << 20);  // 41 bits: exact
  if (!texture.bilinear) {
    const int i =
        endless_texel(texture.wrap, static_cast<std::int64_t>(std::floor(position)), side);
    return {i, i, 0};
  }
  const double k = std::floor(position - 0.5);
  const auto first = static_cast<std::int64_t>(k);
  return {endless_texel(texture.wrap, first, side), endless_texel(texture.wrap, first + 1, side),
          position - 0.5 - k};
}

/// How far a channel of a pixel lies from the mixture of the four texels, in levels.
inline double wide_error(const WideTexture& texture, const reference::UnitFragment& f,
                         const reference::UnitPixel& pixel) {
  const EndlessPlace u = endless_place(texture, f.u, texture.width);
  const EndlessPlace v = endless_place(texture, f.v, texture.height);
  double worst = 0;
  for (unsigned c = 0; c < 3; ++c) {
    const auto channel = [c](int i, int j) {
      return static_cast<double>(wide_texel(i, j) >> 8 * c & 255);
    };
    const double above = std::lerp(channel(u.first, v.first), channel(u.second, v.first), u.weight);
    const double below =
        std::lerp(channel(u.first, v.second), channel(u.second, v.second), u.weight);
    worst = std::max(worst, std::abs(pixel.rgb[c] - std::lerp(above, below, v.weight)));
  }
  return worst;
}

/// Coordinates at both edges and the middle of the texture, where its side's bits change, in it and
/// as far outside as a fragment's format reaches; even, so that texels' weights are exact 256ths.
inline std::vector<reference::UnitFragment> wide_fragments(const WideTexture& texture,
                                                           std::size_t count) {
  std::mt19937 rng(static_cast<unsigned>(texture.width + texture.height));
  const auto in = [&rng](int low, int high) {
    return std::uniform_int_distribution(low, high)(rng);
  };
  const auto coordinate = [&](int side) {
    const int texel = (1 << 20) / side;
    int u = 0;
    switch (in(0, 5)) {
      case 0:  // about the edges of any of 512 copies
        u = in(-256, 255) * (1 << 20) + in(-2 * texel, 2 * texel);
        break;
      case 1:  // about where a bit of the texel's number changes
        u = (1 << in(10, 20)) + in(-2 * texel, 2 * texel);
        break;
      case 2:
        u = in(-(1 << 28), (1 << 28) - 1);
        break;
      case 3:  // the last texels
        u = (1 << 20) - in(0, 8 * texel);
        break;
      default:
        u = in(0, (1 << 20) - 1);
    }
    return std::clamp(u, -(1 << 28), (1 << 28) - 2) & ~1;
  };
  std::vector<reference::UnitFragment> fragments(count);
  for (reference::UnitFragment& f : fragments) {
    f.u = coordinate(texture.width);
    f.v = coordinate(texture.height);
    f.x = static_cast<std::uint16_t>(&f - fragments.data());
  }
  return fragments;
}

}  // namespace ptm::tests
